// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "interfaces/model/room.hpp"

namespace enfilade {

/// What speaks for and against one wall of the room estimate. Nats (natural log-likelihood ratios) for score:
/// evidence, occupied cells for score: paper.
struct WallDiagnostics {
  double occupied = 0.0;
  double free = 0.0;     ///< ≤ 0
  double toll = 0.0;     ///< ≤ 0
  double returns = 0.0;  ///< of the laser that the wall was fitted to
  double moved_m = 0.0;  ///< outwards, by that fit

  bool operator==(const WallDiagnostics&) const = default;
};

/// The best rectangle that has one wall somewhere else, and why it is not the answer.
struct RejectedRectangle {
  Rectangle rectangle;
  double score = 0.0;
  std::string reason;

  bool operator==(const RejectedRectangle&) const = default;
};

enum class GapVerdict : std::uint8_t { kOpen = 0, kPossible = 1, kUnexplored = 2, kNoDoor = 3 };

/// A stretch of wall plane in which something speaks for an opening, whether or not it is one.
struct GapDiagnostics {
  WallInterval gap;
  GapVerdict verdict = GapVerdict::kNoDoor;
  std::string reason;  ///< of the verdict, for people
  double occupied_share = 0.0;
  double free_share = 0.0;
  double foot_free_share = 0.0;  ///< of the cells below the sill height
  double open_nats = 0.0;        ///< ln P(seen | open) − ln P(seen | wall)
  double from_sigma_m = 0.0, to_sigma_m = 0.0;

  bool operator==(const GapDiagnostics&) const = default;
};

/// The plane θ = α of the Hough space about the room, as a small picture: d along columns, p along rows.
struct HoughSlice {
  double yaw_rad = 0.0;
  Point2 origin = Point2::Zero();         ///< where d = p = 0, zone frame
  double d_from_m = 0.0, p_from_m = 0.0;  ///< outer corner of the first cell
  double cell_m = 0.0;
  std::uint32_t columns = 0, rows = 0;
  double full_scale = 0.0;           ///< the votes that level 255 stands for
  std::vector<std::uint8_t> levels;  ///< row by row, columns × rows

  bool operator==(const HoughSlice&) const = default;
};

/// Why the room estimate is what it is (rt/enfilade/room_diagnostics).
struct RoomDiagnostics {
  ZoneTag tag;
  std::uint64_t grid_sequence = 0;
  StampNs stamp_ns = 0;
  bool found = false;
  bool above_furniture = false;  ///< the walls were looked for above furniture
  Rectangle coarse;              ///< eq. 10–13, before the refinement
  double score = 0.0;
  double score_gap = 0.0;  ///< no rectangle scores more than score + score_gap
  std::array<WallDiagnostics, 4> walls;
  double interior = 0.0;  ///< ≤ 0; for walls inside the room
  HoughSlice slice;
  std::vector<RejectedRectangle> rejected;
  std::vector<GapDiagnostics> gaps;

  bool operator==(const RoomDiagnostics&) const = default;
};

}  // namespace enfilade
