// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/wall_votes.hpp"

#include <algorithm>
#include <cmath>

namespace enfilade::room_detector {

namespace {

bool is_wall_like(int occupied) { return occupied >= 2; }

/// How many cells of the band are occupied in a column of wall, in the mean: all of them where the sensor has
/// looked everywhere, few in a coarse scan or far away. What speaks for a wall shrinks with them, and so must
/// what speaks against one.
int ordinary_wall_cells(const ColumnMap& map, const Levels& levels) {
  int cells = 0, columns = 0;
  for (const Column& column : map.columns()) {
    const int occupied = static_cast<int>((column.occupied & levels).count());
    if (!is_wall_like(occupied)) continue;
    cells += occupied;
    ++columns;
  }
  return columns > 0 ? (cells + columns / 2) / columns : 1;
}

}  // namespace

WallVotes::WallVotes(const WallVotesConfig& config, const HoughConfig& hough)
    : config_(config), hough_(hough) {}

const HoughSpace& WallVotes::update(ColumnMap& map, const WallBand& band, const Point2& origin) {
  const auto changed = map.take_changed();
  const int ordinary = ordinary_wall_cells(map, band.levels());
  const bool is_same_space = space_ && space_->origin() == origin && band == band_;
  if (is_same_space && ordinary == ordinary_) {
    for (const std::size_t i : changed) space_->set(i, vote_of(map, map.columns()[i]));
  } else {
    band_ = band;
    levels_ = band.levels();
    ordinary_ = ordinary;
    if (!is_same_space) space_.emplace(hough_, origin, map.resolution_m());
    for (std::size_t i = 0; i < map.columns().size(); ++i) space_->set(i, vote_of(map, map.columns()[i]));
  }
  space_->set_penalties(penalties(map.resolution_m()));
  return *space_;
}

Vote WallVotes::vote_of(const ColumnMap& map, const Column& column) const {
  const int occupied = static_cast<int>((column.occupied & levels_).count());
  Vote vote{map.centre(column), per_cell() * occupied, 0, 0};
  if (!weighs_evidence()) return vote;
  vote.free = per_cell() * std::min(ordinary_, static_cast<int>((column.free & levels_).count()));
  if (is_wall_like(occupied))
    vote.interior = static_cast<int>(std::lround(config_.interior_share * per_cell() * ordinary_));
  return vote;
}

Penalties WallVotes::penalties(double resolution_m) const {
  if (!weighs_evidence()) return {};
  // A bin that a wall runs through holds step / resolution columns of it.
  const double columns = hough_.step_m / resolution_m;
  return {.per_free = config_.free_weight * columns,
          .per_bin = static_cast<int>(std::lround(config_.toll_share * per_cell() * ordinary_ * columns)),
          .near_cells = std::max(1, static_cast<int>(std::lround(columns))),
          .contour_bins = static_cast<int>(std::lround(config_.contour_margin_m / hough_.step_m))};
}

}  // namespace enfilade::room_detector
