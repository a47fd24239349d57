// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/passing_things.hpp"

#include <algorithm>
#include <cmath>

namespace enfilade::explorer {
namespace {

constexpr double kFarthestM = 2.5;  ///< from the robot: farther away beams are too sparse to tell
constexpr int kFewestBeams = 3;     ///< in a column: one alone may be an echo between two things
constexpr double kMostTimes = 0.5;  ///< what is seen more often than that stands

std::uint64_t key_of(CellXY c) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(c.x)) << 32 | static_cast<std::uint32_t>(c.y);
}

CellXY column_of(std::uint64_t key) {
  return {static_cast<std::int32_t>(key >> 32), static_cast<std::int32_t>(key & 0xffffffffU)};
}

/// Whether it holds for the column or one of its eight neighbours.
template <class Holds>
bool any_beside(CellXY c, Holds holds) {
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (holds(CellXY{c.x + dx, c.y + dy})) return true;
  return false;
}

}  // namespace

void PassingThings::clear() {
  begin_watch();
  passed_.clear();
}

void PassingThings::begin_watch() {
  lines_.clear();
  watched_ = 0;
}

void PassingThings::watch(const Pose2& T_zone_base, const std::vector<Point3f>& points, double resolution_m) {
  ++watched_;
  std::unordered_map<std::uint64_t, int> beams;
  for (const Point3f& p : points) {
    const Point2 at{p.x_m, p.y_m};
    if (at.norm() > kFarthestM) continue;
    const Point2 in_zone = T_zone_base * at / resolution_m;
    ++beams[key_of({static_cast<int>(std::floor(in_zone.x())), static_cast<int>(std::floor(in_zone.y()))})];
  }
  for (const auto& [column, count] : beams) lines_[column] += count >= kFewestBeams ? 1 : 0;
}

void PassingThings::end_watch() {
  const auto stands = [&](CellXY c) {
    const auto found = lines_.find(key_of(c));
    return found != lines_.end() && found->second > kMostTimes * watched_;
  };
  for (const auto& [column, count] : lines_) {
    if (any_beside(column_of(column), stands)) {
      passed_.erase(column);
    } else if (count > 0) {
      passed_.insert(column);
    }
  }
}

std::vector<Point2> PassingThings::trail(const ProjectedGrid& grid) const {
  const auto has_passed = [&](CellXY c) { return passed_.contains(key_of(c)); };
  const auto may_stand = [&](CellXY c) {
    return grid.floor(c) == Floor::kObstacle && !any_beside(c, has_passed);
  };
  std::unordered_set<std::uint64_t> seen;
  std::vector<Point2> found;
  for (const std::uint64_t column : passed_) {
    any_beside(column_of(column), [&](CellXY c) {
      const bool is_new = grid.floor(c) == Floor::kObstacle && seen.insert(key_of(c)).second;
      if (is_new && !any_beside(c, may_stand)) found.push_back(grid.centre(c));
      return false;
    });
  }
  return found;
}

}  // namespace enfilade::explorer
