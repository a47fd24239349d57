// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/around_search.hpp"

#include <algorithm>
#include <span>

namespace enfilade::room_detector {
namespace {

constexpr int kFewVotes = 120;   // that spelling planes out is no more work than bounding them
constexpr int kAbreast = 8;      // planes at a time; more know too little of each other
constexpr int kAbreastDear = 2;  // of these, planes past their first bounds: their steps take longer

/// Of lines next to each other: their most votes, and the most less a toll for each bin away from the robot.
struct LineSums {
  int most = 0;
  int bound = kNever;
};

/// The lines `from` to `to` of `sums`; line i costs toll · i, which `toll` < 0 turns round.
LineSums best_line(std::span<const int> sums, int from, int to, int toll) {
  LineSums found;
  for (int i = from; i < to; ++i) {
    const int sum = sums[static_cast<std::size_t>(i)], value = sum - toll * i;
    found.most = sum > found.most ? sum : found.most;
    found.bound = value > found.bound ? value : found.bound;
  }
  return found;
}

/// The best line on each side of the robot, by their sums alone. Each bin away costs two walls a toll.
LineSums best_lines(std::span<const int> sums, int robot, int before, int behind, int toll) {
  const LineSums one = best_line(sums, robot - before, robot, -2 * toll),
                 other = best_line(sums, robot + 1, robot + 1 + behind, 2 * toll);
  return {std::max(one.most, other.most), one.bound + other.bound};  // the robot's own bin cancels out
}

}  // namespace

void AroundSearch::search(const HoughSpace& space, const Point2& robot, const WindowLimits& sides,
                          Incumbent& best) {
  begin(space, robot, sides);
  const auto all = bound_by_sums();
  Planes planes(all.begin(), all.end());
  const int alone_until = best.expansions + config_.alone_expansions;
  while (choose_turns(planes, best.expansions < alone_until ? 1 : kAbreast, best)) {
    if (!best.has_budget()) {
      best.gap_bound = std::max(best.gap_bound, turns_.front().plane.bound);
      return;
    }
    take_turns(best);
    for (const PlaneTurn& turn : turns_) {
      if (turn.next && best.may_lose_to(turn.next->bound, {turn.plane.angle, 0, 0, 0, 0}))
        planes.push(*turn.next);
    }
  }
}

void AroundSearch::begin(const HoughSpace& space, const Point2& robot, const WindowLimits& sides) {
  question_.space = &space;
  question_.robot = robot;
  question_.sides = sides;
  question_.near_bins = config_.near_bins;
  question_.farthest_bins = sides.max_gap - 1;
  highest_ = kNever;
  choices_.resize(static_cast<std::size_t>(space.lattice().angles()));
  for (PlaneSteps& worker : workers_) worker.begin(question_);
}

std::vector<PlaneState> AroundSearch::bound_by_sums() {
  const HoughSpace& space = *question_.space;
  const int toll = space.penalties().per_bin;
  std::vector<PlaneState> planes;
  int most = 0;
  for (int a = 0; a < space.lattice().angles(); ++a) {
    const Reaches r = question_.reaches(a);
    if (*std::min_element(r.begin(), r.end()) <= 0) continue;
    const auto robot = question_.robot_bins(a);
    const LineSums d = best_lines(space.sums_by_d(a), robot.d, r[kD12], r[kD34], toll);
    const LineSums p = best_lines(space.sums_by_p(a), robot.p, r[kD41], r[kD23], toll);
    planes.push_back({d.bound + p.bound, a, d.bound + p.bound});
    most = std::max({most, d.most, p.most});
  }
  look_at_votes(most);
  return planes;
}

void AroundSearch::look_at_votes(int most_of_line) {
  AroundQuestion& q = question_;
  const HoughSpace& space = *q.space;
  q.votes.gather(space, q.robot, q.farthest_bins, most_of_line);
  // Where all votes and charges lie nearer, a wall one bin farther in costs less and holds no less.
  const double charges_bins = space.free_map().farthest_m(q.robot) / space.lattice().step_m();
  const int needed = 2 + std::max(q.votes.farthest_bins(), static_cast<int>(charges_bins));
  const bool has_toll = space.penalties().per_bin > 0;
  if (has_toll) q.farthest_bins = std::min(q.farthest_bins, std::max(q.sides.min_gap, needed));
  q.only_votes_count = !has_toll && !space.free_map().charges() && !q.votes.speak_against();
  q.are_few = q.only_votes_count && q.votes.size() < kFewVotes;
}

/// The planes with the best bounds, as long as they may hold the best rectangle. Whether there are any.
bool AroundSearch::choose_turns(Planes& planes, int most, const Incumbent& best) {
  turns_.clear();
  int dear = 0;
  while (!planes.empty() && std::ssize(turns_) < most && planes.top().bound >= best.score) {
    const PlaneState& plane = planes.top();
    if (best.may_lose_to(plane.bound, {plane.angle, 0, 0, 0, 0})) {
      if (plane.known != PlaneState::kSums && dear++ == kAbreastDear) break;
      turns_.push_back({plane, turns_.empty(), highest_, best, {}});
    }
    planes.pop();
  }
  return !turns_.empty();
}

void AroundSearch::take_turns(Incumbent& best) {
  const auto take = [this](int i, int worker) {
    PlaneTurn& turn = turns_[static_cast<std::size_t>(i)];
    workers_[static_cast<std::size_t>(worker)].advance(turn,
                                                       choices_[static_cast<std::size_t>(turn.plane.angle)]);
  };
  const int count = static_cast<int>(turns_.size());
  if (count > 1 && runner_.workers > 1) {
    CornerBounds::prepare(*question_.space);
    runner_.run(count, take);
  } else {
    for (int i = 0; i < count; ++i) take(i, 0);
  }
  const int expansions = best.expansions, planes_opened = best.planes_opened;
  for (const PlaneTurn& turn : turns_) {
    highest_ = std::max(highest_, turn.highest);
    best.offer(turn.best.rectangle, turn.best.score);
    best.gap_bound = std::max(best.gap_bound, turn.best.gap_bound);
    best.expansions += turn.best.expansions - expansions;
    best.planes_opened += turn.best.planes_opened - planes_opened;
  }
}

}  // namespace enfilade::room_detector
