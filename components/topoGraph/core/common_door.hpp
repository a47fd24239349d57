// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "components/topoGraph/core/placed_face.hpp"

namespace enfilade::topo_graph {

enum class DoorFaces : std::uint8_t {
  kPaper,      ///< eq. 20 to the letter: the midpoints of the two faces are one point
  kThickness,  ///< they differ across the wall by its thickness, and the two walls are parallel
};

struct CommonDoorConfig {
  DoorFaces door_faces = DoorFaces::kThickness;
  double max_thickness_m = 0.4;     ///< a wall is taken to be between 0 and this thick
  double max_rotation_rad = 0.157;  ///< 9°, 3σ of odometry: walls that miss being parallel by more stay so
  double max_distance_m = 1.0;      ///< farther from the known door nothing is corrected
  double max_angle_rad = 0.5236;    ///< 30°: between the two walls
  double max_width_difference_m =
      0.4;  ///< a gap that is wider or narrower by more does not show the door alone
};

/// How a new room meets the door through which the robot came.
struct CommonDoor {
  WallInterval gap;          ///< the door in the new rectangle's wall
  bool seen = false;         ///< whether the estimate shows it; otherwise it is projected from the known face
  bool corrected = false;    ///< false: too far away for eq. 20
  double thickness_m = 0.0;  ///< distance of the two faces across the wall, after the correction
  std::optional<double> measured_thickness_m;  ///< the same as odometry told it, where a wall can be so thick
  Pose2 correction;  ///< new room pose = correction * old room pose, in the map frame
};

/// Eq. 20, T_r2·d_r2 = T_r1·d_r1, solved for the pose of the new room r2. `known` is the door's face d_r1,
/// `rectangle` the new room in the map frame with its gaps `doors`.
class CommonDoorSolver {
 public:
  /// Throws std::invalid_argument where the configuration makes no sense.
  explicit CommonDoorSolver(const CommonDoorConfig& config);

  CommonDoor solve(const PlacedFace& known, const Rectangle& rectangle,
                   const std::vector<DoorEstimate>& doors) const;

 private:
  CommonDoorConfig config_;
};

}  // namespace enfilade::topo_graph
