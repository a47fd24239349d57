// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/rectangle_search.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
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

bool fits(const BinRectangle& r, const HoughSpace& space, const PlaneLimits& limits) {
  const auto within = [&](const WindowLimits& l, int first, int second) {
    return first >= 0 && second < space.lattice().bins() && first <= l.last_first &&
           second >= l.first_second && second - first >= l.min_gap && second - first <= l.max_gap;
  };
  return r.alpha < space.lattice().angles() && within(limits.d, r.d12, r.d34) &&
         within(limits.p, r.d41, r.d23);
}

}  // namespace

RectangleSearch::RectangleSearch(const SearchConfig& config, const HoughConfig& hough, TaskRunner runner)
    : config_(config), around_({}, std::move(runner)) {
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
  std::optional<HoughSpace::Terms> of_last;
  if (config_.search != SearchMethod::kExact) {
    search_each_plane(space, robot, best);
  } else if (of_last = begin_with_last(space, robot, best); robot && config_.robot_inside) {
    around_.search(space, *robot, limits_of(space, 0, config_, std::nullopt).d, best);
  } else {
    search_anywhere(space, best);
  }
  const auto before = std::exchange(last_, std::nullopt);
  is_proven = best.gap_bound <= best.score;
  if (best.score < config_.least_score) return std::nullopt;
  last_ = best.rectangle;
  const bool is_known = of_last && before == last_;
  return SearchResult{.rectangle = best.rectangle,
                      .score = best.score,
                      .walls = is_known ? of_last->walls : space.walls(best.rectangle),
                      .gap = std::max(0, best.gap_bound - best.score),
                      .expansions = best.expansions,
                      .planes_opened = best.planes_opened};
}

/// What the last answer scores now, if it is still within the limits.
std::optional<HoughSpace::Terms> RectangleSearch::begin_with_last(const HoughSpace& space,
                                                                  const std::optional<Point2>& robot,
                                                                  Incumbent& best) const {
  if (!last_ || !fits(*last_, space, limits_of(space, last_->alpha, config_, robot))) return std::nullopt;
  const HoughSpace::Terms terms = space.terms(*last_);
  best.offer(*last_, terms.score);
  return terms;
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
  std::vector<std::pair<int, int>> planes;  // (bound, angle)
  for (int a = 0; a < space.lattice().angles(); ++a)
    planes.emplace_back(bound_of(space, a, limits).total(), a);
  std::stable_sort(planes.begin(), planes.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [bound, angle] : planes) {
    if (!best.may_lose_to(bound, {angle, 0, 0, 0, 0})) continue;
    if (best.planes_opened > 0 && !best.has_budget()) {
      best.gap_bound = std::max(best.gap_bound, bound);
      break;
    }
    plane_.build(space, angle);
    best.expansions += plane_.bins();
    ++best.planes_opened;
    search_plane(plane_, space, limits, best);
  }
}

}  // namespace enfilade::room_detector
