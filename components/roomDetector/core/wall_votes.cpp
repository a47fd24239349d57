// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/wall_votes.hpp"

#include <algorithm>
#include <cmath>

namespace enfilade::room_detector {

namespace {

// ln(P / (1 − P)) of P = 0.95: how sure one ordinary column of wall makes of a wall. Its cells are looked at
// by the same few beams and count as one observation.
const double kNatsPerWallColumn = std::log(0.95 / 0.05);

bool is_wall_like(int occupied) { return occupied >= 2; }

}  // namespace

WallVotes::WallVotes(const WallVotesConfig& config, const HoughConfig& hough)
    : config_(config), hough_(hough) {}

const HoughSpace& WallVotes::update(ColumnMap& map, const WallBand& band, const Point2& origin) {
  const auto changed = map.take_changed();
  const bool is_same_space = space_ && space_->origin() == origin && band == band_;
  if (!space_ || band != band_) {
    counted_.assign(map.columns().size(), 0);
    wall_cells_ = wall_columns_ = 0;
    levels_ = band.levels();
    for (std::size_t i = 0; i < map.columns().size(); ++i) count(i, map.columns()[i]);
  } else {
    for (const std::size_t i : changed) count(i, map.columns()[i]);
  }
  const int ordinary = wall_columns_ > 0 ? (wall_cells_ + wall_columns_ / 2) / wall_columns_ : 1;
  if (is_same_space && ordinary == ordinary_) {
    for (const std::size_t i : changed) space_->set(i, vote_of(map, map.columns()[i]));
  } else {
    band_ = band;
    ordinary_ = ordinary;
    if (!is_same_space) space_.emplace(hough_, origin, map.resolution_m());
    for (std::size_t i = 0; i < map.columns().size(); ++i) space_->set(i, vote_of(map, map.columns()[i]));
  }
  space_->set_penalties(penalties(map.resolution_m()));
  return *space_;
}

double WallVotes::unit() const {
  return weighs_evidence() ? per_cell() * ordinary_ / kNatsPerWallColumn : per_cell();
}

/// Keeps the mean number of occupied cells in a column of wall: all of the band where the sensor has looked
/// everywhere, few in a coarse scan or far away. What speaks for a wall shrinks with them, and so must what
/// speaks against one.
void WallVotes::count(std::size_t index, const Column& column) {
  if (index >= counted_.size()) counted_.resize(index + 1, 0);
  const int occupied = static_cast<int>((column.occupied & levels_).count());
  const int before = counted_[index], now = is_wall_like(occupied) ? occupied : 0;
  wall_cells_ += now - before;
  wall_columns_ += (now > 0) - (before > 0);
  counted_[index] = static_cast<std::int16_t>(now);
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
