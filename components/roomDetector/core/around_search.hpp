// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <queue>
#include <utility>
#include <vector>

#include "components/roomDetector/core/plane_steps.hpp"
#include "components/roomDetector/core/task_runner.hpp"

namespace enfilade::room_detector {

struct AroundSearchConfig {
  int near_bins = 14 * CornerBounds::kBlock;  ///< so far out votes are counted for the first bounds; what
                                              ///< lies beyond is known by the sums of whole lines
  int alone_expansions = 400;                 ///< after so much work planes step beside each other
};

/// The best of all rectangles around the robot, over all planes, best bound first.
///
/// A plane is bounded by the sums of its lines, then taken step by step (PlaneSteps). In a search that takes
/// longer several planes step beside each other, each knowing what had been found before: how many does not
/// depend on the number of workers, nor does the answer or the work.
class AroundSearch {
 public:
  explicit AroundSearch(const AroundSearchConfig& config = {}, TaskRunner runner = {})
      : config_(config),
        runner_(std::move(runner)),
        workers_(static_cast<std::size_t>(std::max(1, runner_.workers))) {}

  /// `sides` are the limits of both sides of a rectangle. Improves `best`, which may hold a first guess.
  void search(const HoughSpace& space, const Point2& robot, const WindowLimits& sides, Incumbent& best);

 private:
  using Planes = std::priority_queue<PlaneState>;

  void begin(const HoughSpace& space, const Point2& robot, const WindowLimits& sides);
  std::vector<PlaneState> bound_by_sums();
  void look_at_votes(int most_of_line);
  bool choose_turns(Planes& planes, int most, const Incumbent& best);
  void take_turns(Incumbent& best);

  AroundSearchConfig config_;
  TaskRunner runner_;
  AroundQuestion question_;
  std::vector<PlaneSteps> workers_;
  std::vector<PlaneTurn> turns_;
  std::vector<CornerChoice> choices_;  // by angle: what matters of it
  int highest_ = kNever;               // of the bounds by blocks
};

}  // namespace enfilade::room_detector
