// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "components/topoGraph/core/map_problem.hpp"
#include "components/topoGraph/core/optimise/graph_solver.hpp"
#include "components/topoGraph/core/placed_face.hpp"
#include "components/topoGraph/core/room_model.hpp"

namespace enfilade::topo_graph {

struct LoopCloserConfig {
  double gate_sigma = 3.0;     ///< of predicted pose and of sizes
  double accept_nats = 5.0;    ///< by which "the same room" must be likelier than "a new room"
  double margin_nats = 3.0;    ///< and than any other stored room
  double space_m2 = 200.0;     ///< in which a new room may lie as likely here as there
  double door_match_m = 0.35;  ///< along a wall, between a door seen now and one stored
  double open_door_nats =
      2.5;  ///< for, where the robot came in by a door that the stored room shows unresolved
  double extra_door_nats = 3.0;    ///< against, for a door where the stored room shows a wall
  double missing_door_nats = 2.0;  ///< against, for a stored door that is not seen
  double overlap_iou = 0.5;        ///< from this overlap on, rooms of other size or place are looked at too
  double other_size_nats = 8.0;    ///< against, for one whose size does not fit
  double search_m = 15.0;          ///< rooms farther from the prediction are not looked at
};

/// A new room as the graph predicts it: coming from `from_room` through `via_door`.
struct Prediction {
  RoomModel model;  ///< in the map frame, canonical
  std::optional<RoomId> from_room;
  std::optional<DoorId> via_door;
  std::optional<WallInterval> entrance;                  ///< in the model's walls
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of (x, y, yaw) beside that of `from_room`
};

/// The stored room that a prediction turned out to be.
struct SameRoom {
  RoomId room = 0;
  double nats = 0.0;  ///< ln P(same room) − ln P(new room)
  Pose2 T_map_model;  ///< the stored room's pose, its sides named as the model's
};

/// Loop closing: candidates by size, door pattern and predicted pose given its uncertainty are scored against
/// the hypothesis "a new room".
class LoopCloser {
 public:
  /// Throws std::invalid_argument where the configuration makes no sense.
  LoopCloser(const LoopCloserConfig& config, const UncertaintyConfig& uncertainty);

  /// The best candidate where it is clearly better than anything else.
  std::optional<SameRoom> find(const TopologicalMap& map, const Prediction& prediction) const;

  /// Uncertainty of a pose reached from a neighbouring room: through its door (eq. 20), or by odometry alone.
  Eigen::Matrix3d step_covariance(double way_m, bool through_door) const;

 private:
  std::vector<SameRoom> score(const TopologicalMap& map, const Prediction& prediction) const;
  std::optional<SameRoom> score_naming(const TopologicalMap& map, const Room& room,
                                       const Prediction& prediction, const Pose2& T_map_seen,
                                       const Eigen::Matrix3d& covariance) const;
  std::optional<double> size_nats(const Room& room, const Room& seen, bool turned) const;
  bool overlaps(const Room& room, const Room& seen) const;
  std::optional<double> door_nats(const TopologicalMap& map, const Room& room, const Prediction& prediction,
                                  const Pose2& T_room_model) const;

  LoopCloserConfig config_;
  UncertaintyConfig uncertainty_;
};

}  // namespace enfilade::topo_graph
