// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "interfaces/geometry/rectangle.hpp"
#include "interfaces/model/zone_tag.hpp"

namespace enfilade {

/// What the grid says about a gap in a wall.
enum class DoorState : std::uint8_t {
  kOpen = 0,        ///< observed free from floor to lintel
  kPossible = 1,    ///< nothing occupied, but too little of it observed
  kUnexplored = 2,  ///< not observed: no door, a place to look at
};

/// A gap in one wall of a rectangle: `from_m` … `to_m` along the wall from its first corner (see Rectangle).
struct WallInterval {
  std::uint8_t wall = 0;
  double from_m = 0.0;
  double to_m = 0.0;

  double width_m() const { return to_m - from_m; }
  double middle_m() const { return 0.5 * (from_m + to_m); }
  bool operator==(const WallInterval&) const = default;
};

/// The interval as a segment in the frame of `rectangle`.
Segment segment_of(const Rectangle& rectangle, const WallInterval& interval);

/// Shares are of the cells of the wall plane within the gap and the door's height band.
struct DoorEvidence {
  double occupied_share = 0.0;
  double free_share = 0.0;
  std::uint32_t beyond_occupied_cells =
      0;  ///< occupied cells above the floor, seen through the gap behind the wall
  std::uint32_t beyond_free_cells = 0;  ///< free cells there

  bool operator==(const DoorEvidence&) const = default;
};

struct DoorEstimate {
  WallInterval gap;
  DoorState state = DoorState::kUnexplored;
  std::optional<double> height_m;  ///< underside of the lintel over the floor, where one was seen
  DoorEvidence evidence;
  double position_sigma_m = 0.0;  ///< standard deviation of gap.middle_m; 0 = not estimated
  double width_sigma_m = 0.0;     ///< of gap.width_m()
  double height_sigma_m = 0.0;    ///< of height_m

  bool operator==(const DoorEstimate&) const = default;
};

/// Covariance of (α, x_c, y_c, w, h), row by row, in rad and m.
using RectangleCovariance = std::array<double, 25>;

/// The room model r(i) at one moment. Everything is in the zone frame.
struct RoomEstimate {
  ZoneTag tag;
  std::uint64_t grid_sequence = 0;  ///< the last grid change taken into account
  StampNs stamp_ns = 0;             ///< of the newest scan line taken into account
  bool found = false;               ///< whether any rectangle fits; the fields below mean nothing otherwise
  Rectangle rectangle;
  double score = 0.0;  ///< H_r (eq. 5), or nats for score: evidence
  std::optional<RectangleCovariance> covariance;
  std::vector<Point2>
      polygon;  ///< outline where the room is more than a rectangle; empty = the rectangle itself
  std::vector<DoorEstimate> doors;     ///< gaps of every state, by wall, then by `from_m`
  double unexplored_wall_share = 1.0;  ///< of the cells of the four wall planes within the door band
  /// r(i+1) of eq. 18–19: the same room fitted to the points of the last sweep alone, sizes held.
  std::optional<Rectangle> recent;
  StampNs recent_stamp_ns = 0;

  bool operator==(const RoomEstimate&) const = default;
};

}  // namespace enfilade
