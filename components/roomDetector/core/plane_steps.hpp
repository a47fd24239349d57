// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "components/roomDetector/core/around_question.hpp"
#include "components/roomDetector/core/corner_bounds.hpp"
#include "components/roomDetector/core/corner_plane.hpp"
#include "components/roomDetector/core/telling_lines.hpp"

namespace enfilade::room_detector {

/// What is known of a plane not yet done with.
struct PlaneState {
  int bound = kNever;
  int angle = 0;
  int walls = 0;  ///< the bound by sums: no rectangle's walls hold more, whatever lies inside
  enum Step { kSums, kBlocks, kDetails, kUnbounded } known = kSums;
  int score = kNever;  ///< to beat when its choice was made

  bool operator<(const PlaneState& other) const {
    return bound < other.bound || (bound == other.bound && angle > other.angle);
  }
};

/// One turn of a plane: where it stands, and what comes of it.
struct PlaneTurn {
  PlaneState plane;
  bool may_look = false;           ///< search it at once where it promises more than all before
  int highest = kNever;            ///< of the bounds by blocks of all planes
  Incumbent best;                  ///< what the others have found before this turn, and what it adds
  std::optional<PlaneState> next;  ///< with a better bound, if it may still hold the best rectangle

  bool may_win(int bound) const { return best.may_lose_to(bound, {plane.angle, 0, 0, 0, 0}); }
};

/// Takes planes from one bound to a better one, and in the end to their rectangles: by blocks of lines with
/// the votes near the robot (CornerBounds), then, if far lines are still among those that matter, by smaller
/// blocks of these with all votes; what is left is spelled out (CornerPlane).
class PlaneSteps {
 public:
  void begin(const AroundQuestion& question);
  /// `choice` is what matters of the plane, kept from one of its turns to the next.
  void advance(PlaneTurn& turn, CornerChoice& choice);

 private:
  std::optional<PlaneState> step(const PlaneState& plane, PlaneTurn& turn, CornerChoice& choice);
  std::optional<PlaneState> bound_by_blocks(const PlaneState& plane, PlaneTurn& turn, CornerChoice& choice);
  PlaneState bound_by_details(const PlaneState& plane, Incumbent& best, CornerChoice& choice);
  void spell_out(int angle, const CornerChoice& choice, Incumbent& best);
  CornerChoice lines_of(int angle, const CornerChoice& choice);

  const AroundQuestion* question_ = nullptr;
  Reaches laid_out_{};
  CornerBounds blocks_, details_;
  TellingLines telling_;
  CornerPlane plane_;
};

}  // namespace enfilade::room_detector
