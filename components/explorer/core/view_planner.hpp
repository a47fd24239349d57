// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "components/explorer/core/path_planner.hpp"
#include "components/explorer/core/view_targets.hpp"

namespace enfilade::explorer {

struct ViewPlannerConfig {
  double lattice_m = 0.45;  ///< between places to look from
  int max_places = 120;     ///< in large rooms the lattice is widened
  int max_targets = 1500;
  double inside_m = 0.3;  ///< places keep this far from the estimated walls
  double sensor_height_m = 0.60;
  double blind_half_angle_deg = 45.0;  ///< of the cone straight behind that the sensor does not see
  double range_m = 12.0;
  double least_gain_m2 = 0.5;  ///< less than this is not worth a sweep
  double linear_m_s = 0.45;    ///< to estimate how long it takes
  double angular_rad_s = 1.1;
  double sweep_s = 8.0;
};

struct View {
  Pose2 pose;  ///< zone frame
  double gain_m2 = 0.0;
  double cost_s = 0.0;
};

/// Which views are asked for.
struct ViewWish {
  std::optional<double> other_than_yaw_rad;  ///< at least a quarter turn away from this one
  std::vector<Pose2> had;                    ///< looked from there already: the same again shows nothing new
  std::vector<Point2> barred;                ///< the way there was found barred: other places are tried
};

/// Whether the place is one of those, or near.
bool is_barred(const Point2& place, const std::vector<Point2>& barred);

/// The next best view: the place and heading with the most unexplored area per second spent, by casting rays
/// through the grid.
class ViewPlanner {
 public:
  explicit ViewPlanner(const ViewPlannerConfig& config);

  /// Nothing where no view is worth a sweep.
  std::optional<View> best(const ProjectedGrid& grid, const Reach& reach, const Rectangle& area,
                           const std::vector<ViewTarget>& targets, const Pose2& robot,
                           const ViewWish& wish = {}) const;
  /// What of `targets` is seen from `pose`.
  std::vector<ViewTarget> seen_from(const ProjectedGrid& grid, const Pose2& pose,
                                    const std::vector<ViewTarget>& targets) const;

 private:
  std::vector<Point2> places(const Reach& reach, const Rectangle& area, const Point2& robot) const;
  std::vector<ViewTarget> visible(const ProjectedGrid& grid, const Point2& place,
                                  const std::vector<ViewTarget>& targets) const;
  bool in_sight(const Pose2& pose, const Eigen::Vector3d& at) const;
  double cost_s(const Reach& reach, const Pose2& view, const Pose2& robot) const;

  ViewPlannerConfig config_;
};

}  // namespace enfilade::explorer
