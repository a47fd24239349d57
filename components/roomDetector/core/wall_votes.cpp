// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/wall_votes.hpp"

#include <algorithm>
#include <cmath>

namespace enfilade::room_detector {

namespace {

// ln(P / (1 − P)) of P = 0.95: how sure one ordinary column of wall makes of a wall. Its cells are looked at
// by the same few beams and count as one observation.
const double kNatsPerWallColumn = std::log(0.95 / 0.05);

constexpr int kSample = 4;  // one column of so many by so many speaks for the free space about it

bool is_wall_like(int occupied) { return occupied >= 2; }
bool is_sample(const Column& column) { return column.x % kSample == 0 && column.y % kSample == 0; }

}  // namespace

WallVotes::WallVotes(const WallVotesConfig& config, const HoughConfig& hough)
    : config_(config), hough_(hough) {}

const HoughSpace& WallVotes::update(ColumnMap& map, const WallBand& band, const Point2& origin,
                                    const std::optional<Point2>& robot) {
  const auto changed = map.take_changed();
  const bool is_same_space = space_ && space_->origin() == origin && band == band_;
  if (!is_same_space) {
    band_ = band;
    space_.emplace(hough_, origin, map.resolution_m());
    connected_.emplace(map.resolution_m(), origin, hough_.range_m);
    count_all(map);
  } else {
    for (const std::size_t i : changed) count(i, map.columns()[i]);
  }
  if (weighs_evidence()) follow_connections(map, robot);
  const int ordinary = wall_columns_ > 0 ? (wall_cells_ + wall_columns_ / 2) / wall_columns_ : 1;
  if (is_same_space && ordinary == ordinary_) {
    for (const std::size_t i : changed) set_vote(map, i);
  } else {
    ordinary_ = ordinary;
    for (std::size_t i = 0; i < map.columns().size(); ++i) set_vote(map, i);
  }
  space_->set_penalties(penalties(map.resolution_m()));
  return *space_;
}

double WallVotes::unit() const {
  return weighs_evidence() ? per_cell() * ordinary_ / kNatsPerWallColumn : per_cell();
}

void WallVotes::count_all(const ColumnMap& map) {
  counted_.clear();
  samples_.clear();
  wall_cells_ = wall_columns_ = 0;
  levels_ = band_.levels();
  for (std::size_t i = 0; i < map.columns().size(); ++i) count(i, map.columns()[i]);
}

/// Keeps the mean number of occupied cells in a column of wall: all of the band where the sensor has looked
/// everywhere, few in a coarse scan or far away. What speaks for a wall shrinks with them, and so must what
/// speaks against one.
void WallVotes::count(std::size_t index, const Column& column) {
  if (index >= counted_.size()) {
    counted_.resize(index + 1);
    if (is_sample(column)) samples_.push_back(index);
  }
  Counted& known = counted_[index];
  const int occupied = count_of(column.occupied & levels_);
  const int now = is_wall_like(occupied) ? occupied : 0;
  wall_cells_ += now - known.wall_cells;
  wall_columns_ += (now > 0) - (known.wall_cells > 0);
  known.wall_cells = static_cast<std::int16_t>(now);
  using Kind = ConnectedSpace::Kind;
  const bool is_open = occupied == 0 && (column.free & levels_).any();
  const Kind kind = now > 0 ? Kind::kWall : is_open ? Kind::kOpen : Kind::kUnknown;
  connected_->change(column.x, column.y, known.kind, kind);
  known.kind = kind;
}

void WallVotes::follow_connections(const ColumnMap& map, const std::optional<Point2>& robot) {
  if (!robot) return;
  connected_->flood(*robot);
  for (const std::size_t i : samples_) {
    const Column& column = map.columns()[i];
    const bool is_apart = connected_->is_apart(column.x, column.y);
    if (is_apart == counted_[i].is_apart) continue;
    counted_[i].is_apart = is_apart;
    set_vote(map, i);
  }
}

void WallVotes::set_vote(const ColumnMap& map, std::size_t index) {
  const Column& column = map.columns()[index];
  const int occupied = count_of(column.occupied & levels_);
  Vote vote{map.centre(column), per_cell() * occupied, 0, 0};
  if (weighs_evidence()) {
    vote.free = per_cell() * std::min(ordinary_, count_of(column.free & levels_));
    const double of_wall = per_cell() * ordinary_;
    if (is_wall_like(occupied))
      vote.interior = static_cast<int>(std::lround(config_.interior_share * of_wall));
    if (counted_[index].is_apart) {
      const double area_m2 = std::pow(kSample * map.resolution_m(), 2);
      vote.interior +=
          static_cast<int>(std::lround(config_.apart_share * of_wall * area_m2 / map.resolution_m()));
    }
  }
  space_->set(index, vote);
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
