// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/around_search.hpp"

#include <algorithm>
#include <queue>
#include <span>

namespace enfilade::room_detector {
namespace {

constexpr int kFewVotes = 120;  // that spelling planes out is no more work than bounding them

struct LineSums {
  int bound = 0;  ///< of two parallel walls
  int most = 0;   ///< of any line
};

/// The best line on each side of the robot, by their sums alone. Each bin away costs two walls a toll.
LineSums best_lines(std::span<const int> sums, int robot, int before, int behind, int toll) {
  const auto best = [&](int count, int step, int& most) {
    int value = kNever;
    for (int away = 1; away <= count; ++away) {
      const int sum = sums[static_cast<std::size_t>(robot + step * away)];
      most = std::max(most, sum);
      value = std::max(value, sum - 2 * toll * away);
    }
    return value;
  };
  LineSums found;
  found.bound = best(before, -1, found.most) + best(behind, 1, found.most);
  return found;
}

}  // namespace

void AroundSearch::search(const HoughSpace& space, const Point2& robot, const WindowLimits& sides,
                          Incumbent& best) {
  begin(space, robot, sides);
  const auto all = bound_by_sums();
  std::priority_queue<Plane> planes(all.begin(), all.end());
  while (!planes.empty()) {
    const Plane plane = planes.top();
    planes.pop();
    if (plane.bound < best.score) return;
    if (!best.may_lose_to(plane.bound, {plane.angle, 0, 0, 0, 0})) continue;
    if (!best.has_budget()) {
      best.gap_bound = std::max(best.gap_bound, plane.bound);
      return;
    }
    if (const auto next = advance(plane, best)) planes.push(*next);
  }
}

void AroundSearch::begin(const HoughSpace& space, const Point2& robot, const WindowLimits& sides) {
  space_ = &space;
  robot_ = robot;
  sides_ = sides;
  farthest_ = sides.max_gap - 1;
  highest_ = kNever;
  laid_out_ = {};
  choices_.resize(static_cast<std::size_t>(space.lattice().angles()));
}

std::vector<AroundSearch::Plane> AroundSearch::bound_by_sums() {
  std::vector<Plane> planes;
  const int toll = space_->penalties().per_bin;
  int most = 0;
  for (int a = 0; a < space_->lattice().angles(); ++a) {
    const Reaches r = reaches(a);
    if (*std::min_element(r.begin(), r.end()) <= 0) continue;
    const auto robot = robot_bins(a);
    const LineSums d = best_lines(space_->sums_by_d(a), robot.d, r[kD12], r[kD34], toll);
    const LineSums p = best_lines(space_->sums_by_p(a), robot.p, r[kD41], r[kD23], toll);
    planes.push_back({d.bound + p.bound, a, d.bound + p.bound});
    most = std::max({most, d.most, p.most});
  }
  votes_.gather(*space_, robot_, farthest_, most);
  // Where all votes and charges lie nearer, a wall one bin farther in costs less and holds no less.
  const double charges_bins = space_->free_map().farthest_m(robot_) / space_->lattice().step_m();
  const int needed = 2 + std::max(votes_.farthest_bins(), static_cast<int>(charges_bins));
  if (toll > 0) farthest_ = std::min(farthest_, std::max(sides_.min_gap, needed));
  only_votes_count_ = toll == 0 && !space_->free_map().charges() && !votes_.speak_against();
  are_few_ = only_votes_count_ && votes_.size() < kFewVotes;
  return planes;
}

/// A plane that promises more than all before it is searched at once: the better the rectangles that are
/// known, the less there is to look into elsewhere.
std::optional<AroundSearch::Plane> AroundSearch::look_first(const Plane& plane, Incumbent& best) {
  const int highest = highest_;
  auto next = bound_by_blocks(plane, best);
  while (next && highest_ > highest && best.has_budget()) next = advance(*next, best);
  return next;
}

/// The plane with a better bound, if it may still hold the best rectangle.
std::optional<AroundSearch::Plane> AroundSearch::advance(const Plane& plane, Incumbent& best) {
  std::optional<Plane> next;
  if (plane.known == Plane::kSums)
    next = look_first(plane, best);
  else if (plane.known == Plane::kBlocks || (plane.known == Plane::kDetails && plane.score < best.score))
    next = bound_by_details(plane, best);
  else
    spell_out(plane.angle, choices_[static_cast<std::size_t>(plane.angle)], best);
  if (next && !best.may_lose_to(next->bound, {plane.angle, 0, 0, 0, 0})) return std::nullopt;
  return next;
}

std::optional<AroundSearch::Plane> AroundSearch::bound_by_blocks(const Plane& plane, Incumbent& best) {
  const Reaches r = reaches(plane.angle);
  CornerChoice& choice = choices_[static_cast<std::size_t>(plane.angle)];
  if (!votes_.fit_strips() || are_few_) {
    choice = CornerBounds::everything(r, config_.near_bins);
    return Plane{plane.bound, plane.angle, plane.walls, Plane::kUnbounded, best.score};
  }
  if (r != laid_out_) blocks_.lay_out(*space_, votes_, CornerBounds::everything(r, config_.near_bins));
  laid_out_ = r;
  blocks_.build(*space_, plane.angle, robot_bins(plane.angle), best.score, plane.walls, limits(plane.angle));
  best.expansions += blocks_.work();
  if (!best.may_lose_to(blocks_.bound(), {plane.angle, 0, 0, 0, 0})) return std::nullopt;
  if (blocks_.bound() > highest_) {
    highest_ = blocks_.bound();
    spell_out(plane.angle, blocks_.best(), best);
    blocks_.raise(best.score, limits(plane.angle));
  }
  choice = blocks_.choice();
  const auto known = blocks_.has_far() ? Plane::kBlocks : Plane::kDetails;
  return Plane{blocks_.bound(), plane.angle, plane.walls, known, best.score};
}

std::optional<AroundSearch::Plane> AroundSearch::bound_by_details(const Plane& plane, Incumbent& best) {
  CornerChoice& choice = choices_[static_cast<std::size_t>(plane.angle)];
  details_.lay_out(*space_, votes_, choice.cut(CornerBounds::kBlock));
  details_.build(*space_, plane.angle, robot_bins(plane.angle), best.score, plane.walls, limits(plane.angle));
  best.expansions += details_.work();
  choice = details_.choice();
  return Plane{details_.bound(), plane.angle, plane.walls, Plane::kDetails, best.score};
}

void AroundSearch::spell_out(int angle, const CornerChoice& choice, Incumbent& best) {
  plane_.build(*space_, votes_, angle, robot_bins(angle), lines_of(angle, choice));
  best.expansions += plane_.work();
  ++best.planes_opened;
  plane_.search(limits(angle), best);
}

CornerChoice AroundSearch::lines_of(int angle, const CornerChoice& choice) {
  if (!only_votes_count_) return choice.cut(CornerBounds::kBlock);
  telling_.find(votes_, space_->binning(angle), robot_bins(angle), reaches(angle), sides_);
  return choice.cut(CornerBounds::kBlock, [&](int side, int away) { return telling_.hold(side, away); });
}

PlaneLimits AroundSearch::limits(int angle) const {
  const auto around = [&](int robot) {
    WindowLimits limits = sides_;
    limits.last_first = robot - 1;
    limits.first_second = robot + 1;
    return limits;
  };
  const auto robot = robot_bins(angle);
  return {around(robot.d), around(robot.p)};
}

Reaches AroundSearch::reaches(int angle) const {
  const auto robot = robot_bins(angle);
  const int last = space_->lattice().bins() - 1;
  return {std::min(robot.d, farthest_), std::min(last - robot.d, farthest_), std::min(robot.p, farthest_),
          std::min(last - robot.p, farthest_)};
}

}  // namespace enfilade::room_detector
