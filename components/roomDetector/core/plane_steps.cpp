// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/plane_steps.hpp"

#include <algorithm>

namespace enfilade::room_detector {

void PlaneSteps::begin(const AroundQuestion& question) {
  question_ = &question;
  laid_out_ = {};
}

/// A plane that promises more than all before it is searched at once: the better the rectangles that are
/// known, the less there is to look into elsewhere.
void PlaneSteps::advance(PlaneTurn& turn, CornerChoice& choice) {
  const int before = turn.highest;
  turn.next = step(turn.plane, turn, choice);
  while (turn.next && turn.may_look && turn.highest > before && turn.best.has_budget())
    turn.next = step(*turn.next, turn, choice);
}

std::optional<PlaneState> PlaneSteps::step(const PlaneState& plane, PlaneTurn& turn, CornerChoice& choice) {
  const int score = turn.best.score;
  std::optional<PlaneState> next;
  if (plane.known == PlaneState::kSums)
    next = bound_by_blocks(plane, turn, choice);
  else if (plane.known == PlaneState::kBlocks || (plane.known == PlaneState::kDetails && plane.score < score))
    next = bound_by_details(plane, turn.best, choice);
  else
    spell_out(plane.angle, choice, turn.best);
  if (next && !turn.may_win(next->bound)) return std::nullopt;
  return next;
}

std::optional<PlaneState> PlaneSteps::bound_by_blocks(const PlaneState& plane, PlaneTurn& turn,
                                                      CornerChoice& choice) {
  const AroundQuestion& q = *question_;
  const Reaches reaches = q.reaches(plane.angle);
  const PlaneLimits limits = q.limits(plane.angle);
  Incumbent& best = turn.best;
  if (!q.votes.fit_strips() || q.are_few) {
    choice = CornerBounds::everything(reaches, q.near_bins);
    return PlaneState{plane.bound, plane.angle, plane.walls, PlaneState::kUnbounded, best.score};
  }
  if (reaches != laid_out_)
    blocks_.lay_out(*q.space, q.votes, CornerBounds::everything(reaches, q.near_bins));
  laid_out_ = reaches;
  blocks_.build(*q.space, plane.angle, q.robot_bins(plane.angle), best.score, plane.walls, limits);
  best.expansions += blocks_.work();
  if (!turn.may_win(blocks_.bound())) return std::nullopt;
  if (turn.may_look && blocks_.bound() > turn.highest) {
    spell_out(plane.angle, blocks_.best(), best);
    blocks_.raise(best.score, limits);
  }
  turn.highest = std::max(turn.highest, blocks_.bound());
  choice = blocks_.choice();
  const auto known = blocks_.has_far() ? PlaneState::kBlocks : PlaneState::kDetails;
  return PlaneState{blocks_.bound(), plane.angle, plane.walls, known, best.score};
}

PlaneState PlaneSteps::bound_by_details(const PlaneState& plane, Incumbent& best, CornerChoice& choice) {
  const AroundQuestion& q = *question_;
  details_.lay_out(*q.space, q.votes, choice.cut(CornerBounds::kBlock));
  details_.build(*q.space, plane.angle, q.robot_bins(plane.angle), best.score, plane.walls,
                 q.limits(plane.angle));
  best.expansions += details_.work();
  choice = details_.choice();
  return {details_.bound(), plane.angle, plane.walls, PlaneState::kDetails, best.score};
}

void PlaneSteps::spell_out(int angle, const CornerChoice& choice, Incumbent& best) {
  const AroundQuestion& q = *question_;
  plane_.build(*q.space, q.votes, angle, q.robot_bins(angle), lines_of(angle, choice));
  best.expansions += plane_.work();
  ++best.planes_opened;
  plane_.search(q.limits(angle), best);
}

CornerChoice PlaneSteps::lines_of(int angle, const CornerChoice& choice) {
  const AroundQuestion& q = *question_;
  if (!q.only_votes_count) return choice.cut(CornerBounds::kBlock);
  telling_.find(q.votes, q.space->binning(angle), q.robot_bins(angle), q.reaches(angle), q.sides);
  return choice.cut(CornerBounds::kBlock, [&](int side, int away) { return telling_.hold(side, away); });
}

}  // namespace enfilade::room_detector
