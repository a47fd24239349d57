// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "components/roomDetector/core/corner_bounds.hpp"
#include "components/roomDetector/core/corner_plane.hpp"
#include "components/roomDetector/core/near_votes.hpp"
#include "components/roomDetector/core/plane_search.hpp"
#include "components/roomDetector/core/telling_lines.hpp"

namespace enfilade::room_detector {

struct AroundSearchConfig {
  int near_bins = 14 * CornerBounds::kBlock;  ///< so far out votes are counted for the first bounds; what
                                              ///< lies beyond is known by the sums of whole lines
};

/// The best of all rectangles around the robot, over all planes, best bound first.
///
/// A plane is bounded by the sums of its lines, then by blocks of lines with the votes near the robot
/// (CornerBounds), then, if far lines are still among those that matter, by smaller blocks of these with all
/// votes; what is left of it is spelled out (CornerPlane).
class AroundSearch {
 public:
  explicit AroundSearch(const AroundSearchConfig& config = {}) : config_(config) {}

  /// `sides` are the limits of both sides of a rectangle. Improves `best`, which may hold a first guess.
  void search(const HoughSpace& space, const Point2& robot, const WindowLimits& sides, Incumbent& best);

 private:
  /// What is known of a plane not yet done with.
  struct Plane {
    int bound;
    int angle;
    int walls;  ///< the bound by sums: no rectangle's walls hold more, whatever lies inside
    enum Step { kSums, kBlocks, kDetails, kUnbounded } known = kSums;
    int score = kNever;  ///< to beat when its choice was made

    bool operator<(const Plane& other) const {
      return bound < other.bound || (bound == other.bound && angle > other.angle);
    }
  };

  void begin(const HoughSpace& space, const Point2& robot, const WindowLimits& sides);
  std::vector<Plane> bound_by_sums();
  std::optional<Plane> look_first(const Plane& plane, Incumbent& best);
  std::optional<Plane> advance(const Plane& plane, Incumbent& best);
  std::optional<Plane> bound_by_blocks(const Plane& plane, Incumbent& best);
  std::optional<Plane> bound_by_details(const Plane& plane, Incumbent& best);
  void spell_out(int angle, const CornerChoice& choice, Incumbent& best);
  HoughSpace::Bins robot_bins(int angle) const { return space_->bins_of(angle, robot_); }
  CornerChoice lines_of(int angle, const CornerChoice& choice);
  PlaneLimits limits(int angle) const;
  Reaches reaches(int angle) const;

  AroundSearchConfig config_;
  const HoughSpace* space_ = nullptr;
  Point2 robot_ = Point2::Zero();
  WindowLimits sides_;
  int farthest_ = 0;      // no better rectangle has a line farther from the robot, in bins
  int highest_ = kNever;  // of the bounds by blocks
  bool only_votes_count_ = false, are_few_ = false;
  Reaches laid_out_{};
  std::vector<CornerChoice> choices_;  // by angle: what matters of it
  NearVotes votes_;
  CornerBounds blocks_, details_;
  TellingLines telling_;
  CornerPlane plane_;
};

}  // namespace enfilade::room_detector
