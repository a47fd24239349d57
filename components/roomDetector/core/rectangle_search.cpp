// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/rectangle_search.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <span>
#include <stdexcept>
#include <vector>

#include "components/roomDetector/core/baselines.hpp"
#include "components/roomDetector/core/plane_search.hpp"

namespace enfilade::room_detector {
namespace {

constexpr double kMostEntries = 4e6;  // of the literal table; the paper's experiment has half a million

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

/// A plane not yet looked into, with the best bound known.
struct Plane {
  int bound;
  int angle;
  int bounded_at = kNever;  ///< the score to beat when the reaches were taken from the bounds of corners …
  Reaches reaches;          ///< … or all that the limits allow

  bool operator<(const Plane& other) const {
    return bound < other.bound || (bound == other.bound && angle > other.angle);
  }
};

Reaches reaches_of(const HoughSpace& space, const HoughSpace::Bins& robot, const PlaneLimits& limits) {
  const int bins = space.lattice().bins(), d = limits.d.max_gap - 1, p = limits.p.max_gap - 1;
  return {std::min(robot.d, d), std::min(bins - 1 - robot.d, d), std::min(robot.p, p),
          std::min(bins - 1 - robot.p, p)};
}

/// The best line on each side of the robot, by their sums alone.
int bound_by_sums(std::span<const int> sums, int robot, int before, int behind) {
  const auto most = [&](int from, int to) {
    int value = 0;
    for (int i = from; i < to; ++i)
      value = sums[static_cast<std::size_t>(i)] > value ? sums[static_cast<std::size_t>(i)] : value;
    return value;
  };
  return most(robot - before, robot) + most(robot + 1, robot + 1 + behind);
}

bool fits(const BinRectangle& r, const HoughSpace& space, const PlaneLimits& limits) {
  const auto within = [&](const WindowLimits& l, int first, int second) {
    return first >= 0 && second < space.lattice().bins() && first <= l.last_first &&
           second >= l.first_second && second - first >= l.min_gap && second - first <= l.max_gap;
  };
  return r.alpha < space.lattice().angles() && within(limits.d, r.d12, r.d34) &&
         within(limits.p, r.d41, r.d23);
}

}  // namespace

RectangleSearch::RectangleSearch(const SearchConfig& config, const HoughConfig& hough) : config_(config) {
  if (config.side_min_m >= config.side_max_m)
    throw std::invalid_argument("side_min_m must be less than side_max_m");
  const bool is_literal = config.search == SearchMethod::kLiteral;
  if (is_literal && LiteralHough::table_size(HoughLattice(hough)) > kMostEntries)
    throw std::invalid_argument(
        "search: literal would take hours with so many bins; try the paper's step_m: 0.27, theta_step_deg: "
        "5");
}

std::optional<SearchResult> RectangleSearch::find_best(const HoughSpace& space,
                                                       const std::optional<Point2>& robot) {
  const Question question{space.fingerprint(),      space.penalties(),     space.origin(), robot,
                          space.lattice().angles(), space.lattice().bins()};
  if (question_ == question) {
    if (answer_) answer_->expansions = answer_->planes_opened = 0;
    return answer_;
  }
  bool is_proven = false;
  answer_ = search(space, robot, is_proven);
  question_.reset();
  if (is_proven) question_ = question;
  return answer_;
}

std::optional<SearchResult> RectangleSearch::search(const HoughSpace& space,
                                                    const std::optional<Point2>& robot, bool& is_proven) {
  Incumbent best{.rectangle = {}, .score = config_.least_score - 1, .max_expansions = config_.max_expansions};
  if (config_.search != SearchMethod::kExact) {
    search_each_plane(space, robot, best);
  } else if (begin_with_last(space, robot, best); robot && config_.robot_inside) {
    search_around(space, *robot, best);
  } else {
    search_anywhere(space, best);
  }
  last_.reset();
  is_proven = best.gap_bound <= best.score;
  if (best.score < config_.least_score) return std::nullopt;
  last_ = best.rectangle;
  return SearchResult{.rectangle = best.rectangle,
                      .score = best.score,
                      .walls = space.walls(best.rectangle),
                      .gap = std::max(0, best.gap_bound - best.score),
                      .expansions = best.expansions,
                      .planes_opened = best.planes_opened};
}

void RectangleSearch::begin_with_last(const HoughSpace& space, const std::optional<Point2>& robot,
                                      Incumbent& best) const {
  if (last_ && fits(*last_, space, limits_of(space, last_->alpha, config_, robot)))
    best.offer(*last_, space.score(*last_));
}

void RectangleSearch::search_each_plane(const HoughSpace& space, const std::optional<Point2>& robot,
                                        Incumbent& best) const {
  const bool is_literal = config_.search == SearchMethod::kLiteral;
  const auto table = is_literal ? std::optional<LiteralHough>(space) : std::nullopt;
  for (int a = 0; a < space.lattice().angles(); ++a, ++best.planes_opened) {
    const PlaneLimits limits = limits_of(space, a, config_, robot);
    if (is_literal)
      table->search(a, limits, best);
    else
      search_by_lines(space, a, limits, best);
  }
}

void RectangleSearch::search_anywhere(const HoughSpace& space, Incumbent& best) {
  const PlaneLimits limits = limits_of(space, 0, config_, std::nullopt);
  std::vector<Plane> planes;
  for (int a = 0; a < space.lattice().angles(); ++a)
    planes.push_back({bound_of(space, a, limits).total(), a, kNever, {}});
  std::sort(planes.rbegin(), planes.rend());
  for (const Plane& plane : planes) {
    if (!best.may_lose_to(plane.bound, {plane.angle, 0, 0, 0, 0})) continue;
    if (best.planes_opened > 0 && !best.has_budget()) {
      best.gap_bound = std::max(best.gap_bound, plane.bound);
      break;
    }
    plane_.build(space, plane.angle);
    best.expansions += plane_.bins();
    ++best.planes_opened;
    search_plane(plane_, space, limits, best);
  }
}

void RectangleSearch::look_into(const HoughSpace& space, int angle, const HoughSpace::Bins& robot,
                                const Reaches& reaches, const PlaneLimits& limits, Incumbent& best) {
  corners_.build(space, angle, robot, reaches);
  best.expansions += 1 + (reaches.d12 + reaches.d34) * (reaches.d41 + reaches.d23) / 128;
  ++best.planes_opened;
  corners_.search(limits, best);
}

void RectangleSearch::search_around(const HoughSpace& space, const Point2& robot, Incumbent& best) {
  std::priority_queue<Plane> planes;
  for (int a = 0; a < space.lattice().angles(); ++a) {
    const auto bins = space.bins_of(a, robot);
    const Reaches reaches = reaches_of(space, bins, limits_of(space, a, config_, robot));
    if (reaches.is_empty()) continue;
    planes.push({bound_by_sums(space.sums_by_d(a), bins.d, reaches.d12, reaches.d34) +
                     bound_by_sums(space.sums_by_p(a), bins.p, reaches.d41, reaches.d23),
                 a, kNever, reaches});
  }
  int highest = last_ ? best.score : kNever;  // bound from corners
  while (!planes.empty()) {
    const Plane plane = planes.top();
    planes.pop();
    if (!best.may_lose_to(plane.bound, {plane.angle, 0, 0, 0, 0})) {
      if (plane.bound < best.score) return;
      continue;
    }
    if (!best.has_budget()) {
      best.gap_bound = std::max(best.gap_bound, plane.bound);
      return;
    }
    const auto bins = space.bins_of(plane.angle, robot);
    const PlaneLimits limits = limits_of(space, plane.angle, config_, robot);
    if (plane.bounded_at == best.score) {
      look_into(space, plane.angle, bins, plane.reaches, limits, best);
      continue;
    }
    const int score = best.score;
    bounds_.build(space, plane.angle, bins, plane.reaches, score);
    best.expansions += 1 + bounds_.bins() / 512 + static_cast<int>(space.wall_votes().size() / 64);
    if (!best.may_lose_to(bounds_.bound(), {plane.angle, 0, 0, 0, 0})) continue;
    if (bounds_.bound() > highest) look_into(space, plane.angle, bins, bounds_.best_reaches(), limits, best);
    highest = std::max(highest, bounds_.bound());
    planes.push({bounds_.bound(), plane.angle, score, bounds_.reaches()});
  }
}

}  // namespace enfilade::room_detector
