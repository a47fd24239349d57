// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/rectangle_search.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "components/roomDetector/core/plane_search.hpp"

namespace enfilade::room_detector {
namespace {

PlaneLimits limits_of(const HoughSpace& space, int angle, const SearchConfig& config,
                      const std::optional<Point2>& robot) {
  const double step = space.lattice().step_m();
  WindowLimits sides;
  sides.min_gap = std::max(1, static_cast<int>(std::ceil(config.side_min_m / step - 1e-9)));
  sides.max_gap = static_cast<int>(std::floor(config.side_max_m / step + 1e-9));
  PlaneLimits limits{sides, sides};
  if (robot && config.robot_inside) {
    const auto bins = space.bins_of(angle, *robot);
    limits.d.last_first = bins.d - 1;
    limits.d.first_second = bins.d + 1;
    limits.p.last_first = bins.p - 1;
    limits.p.first_second = bins.p + 1;
  }
  return limits;
}

struct Angle {
  int index;
  PlaneLimits limits;
  int bound;
};

/// All planes, best bound first.
std::vector<Angle> angles_by_bound(const HoughSpace& space, const SearchConfig& config,
                                   const std::optional<Point2>& robot) {
  std::vector<Angle> angles;
  for (int a = 0; a < space.lattice().angles(); ++a) {
    const PlaneLimits limits = limits_of(space, a, config, robot);
    angles.push_back({a, limits, bound_of(space, a, limits).total()});
  }
  std::stable_sort(angles.begin(), angles.end(),
                   [](const Angle& a, const Angle& b) { return a.bound > b.bound; });
  return angles;
}

}  // namespace

RectangleSearch::RectangleSearch(const SearchConfig& config) : config_(config) {
  if (config.side_min_m >= config.side_max_m)
    throw std::invalid_argument("side_min_m must be less than side_max_m");
}

std::optional<SearchResult> RectangleSearch::find_best(const HoughSpace& space,
                                                       const std::optional<Point2>& robot) {
  Incumbent best{.max_expansions = config_.max_expansions};
  SearchResult result;
  for (const Angle& angle : angles_by_bound(space, config_, robot)) {
    if (!best.may_lose_to(angle.bound, {angle.index, 0, 0, 0, 0})) continue;
    if (result.planes_opened > 0 && !best.has_budget()) {
      best.gap_bound = std::max(best.gap_bound, angle.bound);
      break;
    }
    plane_.build(space, angle.index);
    best.expansions += plane_.bins();
    ++result.planes_opened;
    search_plane(plane_, space, angle.limits, best);
  }
  if (best.score <= kNever / 2) return std::nullopt;
  if (plane_.alpha() != best.rectangle.alpha) plane_.build(space, best.rectangle.alpha);
  result.walls = plane_.walls(best.rectangle);
  result.rectangle = best.rectangle;
  result.score = best.score;
  result.gap = std::max(0, best.gap_bound - best.score);
  result.expansions = best.expansions;
  return result;
}

}  // namespace enfilade::room_detector
