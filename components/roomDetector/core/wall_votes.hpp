// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "components/roomDetector/core/connected_space.hpp"
#include "components/roomDetector/core/hough_space.hpp"
#include "components/roomDetector/core/wall_band.hpp"

namespace enfilade::room_detector {

enum class Score { kPaper, kEvidence };

struct WallVotesConfig {
  Score score = Score::kEvidence;  ///< kPaper: occupied cells count one each, nothing else counts
  double free_weight =
      1.0;  ///< kEvidence: a free column on the contour says as much as an ordinary one of wall
  double interior_share = 0.2;  ///< kEvidence: wall inside the room takes away so much of an ordinary wall
                                ///< column: it may be furniture up to the ceiling
  double apart_share = 2.0;  ///< kEvidence: a square metre of free space apart from the robot takes away so
                             ///< many metres of ordinary wall
  double toll_share = 0.05;  ///< kEvidence: contour costs so much of an ordinary wall
  double contour_margin_m = 0.15;  ///< kEvidence: what is so near to a wall is a part of it, not inside
};

/// Keeps the Hough space in step with the grid: every column of the grid votes with the cells of the wall
/// band.
class WallVotes {
 public:
  WallVotes(const WallVotesConfig& config, const HoughConfig& hough);

  /// Brings the space up to date with the columns changed since the last call; all of them when the band or
  /// the origin has changed.
  const HoughSpace& update(ColumnMap& map, const WallBand& band, const Point2& origin,
                           const std::optional<Point2>& robot);
  void clear() { space_.reset(); }
  /// As of the last update; null before the first.
  const HoughSpace* space() const { return space_ ? &*space_ : nullptr; }
  /// What a score of one unit is in the votes: a nat where evidence is weighed, else an occupied cell.
  double unit() const;
  /// Votes of so much wall as this grid shows it.
  double wall(double length_m, double resolution_m) const {
    return per_cell() * ordinary_ * length_m / resolution_m;
  }

 private:
  bool weighs_evidence() const { return config_.score == Score::kEvidence && band_.above_furniture; }
  int per_cell() const { return weighs_evidence() ? 4 : 1; }
  void count_all(const ColumnMap& map);
  void count(std::size_t index, const Column& column);
  void set_vote(const ColumnMap& map, std::size_t index);
  void follow_connections(const ColumnMap& map, const std::optional<Point2>& robot);
  Penalties penalties(double resolution_m) const;

  WallVotesConfig config_;
  HoughConfig hough_;
  WallBand band_;
  Levels levels_;
  struct Counted {
    std::int16_t wall_cells = 0;  // of the band, if the column is wall
    ConnectedSpace::Kind kind = ConnectedSpace::Kind::kUnknown;
    bool is_apart = false;
  };
  std::vector<Counted> counted_;      // by column
  std::vector<std::size_t> samples_;  // columns that speak for the free space about them
  std::optional<ConnectedSpace> connected_;
  int wall_cells_ = 0, wall_columns_ = 0;
  int ordinary_ = 1;  // cells of a wall column, as this grid shows them
  std::optional<HoughSpace> space_;
};

}  // namespace enfilade::room_detector
