// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "components/roomDetector/core/hough_space.hpp"
#include "components/roomDetector/core/wall_band.hpp"

namespace enfilade::room_detector {

enum class Score { kPaper, kEvidence };

struct WallVotesConfig {
  Score score = Score::kEvidence;  ///< kPaper: occupied cells count one each, nothing else counts
  double free_weight = 0.5;  ///< kEvidence: a free cell on the contour takes away so much of an occupied one
  double interior_share =
      1.5;  ///< kEvidence: wall inside the room takes away so much of an ordinary wall column
  double toll_share = 0.05;        ///< kEvidence: contour costs so much of an ordinary wall
  double contour_margin_m = 0.15;  ///< kEvidence: what is so near to a wall is a part of it, not inside
};

/// Keeps the Hough space in step with the grid: every column of the grid votes with the cells of the wall
/// band.
class WallVotes {
 public:
  WallVotes(const WallVotesConfig& config, const HoughConfig& hough);

  /// Brings the space up to date with the columns changed since the last call; all of them when the band or
  /// the origin has changed.
  const HoughSpace& update(ColumnMap& map, const WallBand& band, const Point2& origin);
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
  void count(std::size_t index, const Column& column);
  Vote vote_of(const ColumnMap& map, const Column& column) const;
  Penalties penalties(double resolution_m) const;

  WallVotesConfig config_;
  HoughConfig hough_;
  WallBand band_;
  Levels levels_;
  std::vector<std::int16_t> counted_;  // cells of the band, by column of wall
  int wall_cells_ = 0, wall_columns_ = 0;
  int ordinary_ = 1;  // cells of a wall column, as this grid shows them
  std::optional<HoughSpace> space_;
};

}  // namespace enfilade::room_detector
