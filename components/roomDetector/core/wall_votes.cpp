// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/wall_votes.hpp"

#include <algorithm>
#include <cmath>

namespace enfilade::room_detector {

WallVotes::WallVotes(const WallVotesConfig& config, const HoughConfig& hough)
    : config_(config), hough_(hough) {}

const HoughSpace& WallVotes::update(ColumnMap& map, const WallBand& band, const Point2& origin) {
  const auto changed = map.take_changed();
  if (!space_ || space_->origin() != origin || !(band == band_)) {
    band_ = band;
    levels_ = band.levels();
    space_.emplace(hough_, origin);
    for (std::size_t i = 0; i < map.columns().size(); ++i) space_->set(i, vote_of(map, map.columns()[i]));
  } else {
    for (const std::size_t i : changed) space_->set(i, vote_of(map, map.columns()[i]));
  }
  space_->set_penalties(penalties(map.resolution_m()));
  return *space_;
}

Vote WallVotes::vote_of(const ColumnMap& map, const Column& column) const {
  const int occupied = static_cast<int>((column.occupied & levels_).count());
  Vote vote{map.centre(column), per_cell() * occupied, 0, 0};
  if (!weighs_evidence()) return vote;
  vote.free = per_cell() * static_cast<int>((column.free & levels_).count());
  const bool is_wall_like = occupied >= 2;
  if (is_wall_like)
    vote.interior = static_cast<int>(std::lround(config_.interior_share * per_cell() * band_.size()));
  return vote;
}

Penalties WallVotes::penalties(double resolution_m) const {
  if (!weighs_evidence()) return {};
  // A bin that a wall runs through holds step / resolution columns of it, and that many times as many free
  // ones if it is not there.
  const double columns = hough_.step_m / resolution_m;
  return {config_.free_weight / std::max(1.0, columns),
          static_cast<int>(std::lround(config_.toll_share * per_cell() * band_.size() * columns))};
}

}  // namespace enfilade::room_detector
