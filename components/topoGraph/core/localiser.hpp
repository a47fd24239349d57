// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "interfaces/model/topological_map.hpp"

namespace enfilade::topo_graph {

struct LocaliserConfig {
  double size_sigma_m = 0.05;      ///< of a side, between model and map
  double door_sigma_m = 0.15;      ///< of a door along its wall
  double missing_door_nats = 5.0;  ///< against, for a door that only the map or only the model has
  double motion_sigma_m = 0.3;     ///< of odometry between two models, beside `motion_share`
  double motion_share = 0.05;
  double motion_sigma_rad = 0.1;
  double elsewhere_nats = 12.0;  ///< against, of a room that the map does not hold
  double certain = 0.99;         ///< probability from which the place is told
};

/// Where the robot may be, with which probability.
struct PlaceHypothesis {
  RoomId room = 0;
  Pose2 T_map_zone;
  double log_weight = 0.0;
};

/// Global localisation: started with a map and no pose, the hypotheses "this is room r, its sides named so"
/// are weighed by size and door pattern, and from model to model by where odometry says the next room lies.
/// Symmetric rooms stay several hypotheses until doors or motion tell them apart.
class Localiser {
 public:
  /// Throws std::invalid_argument where the configuration makes no sense.
  explicit Localiser(const LocaliserConfig& config);

  /// A model of the room in which the robot is, in the frame of a zone whose frame is odom throughout.
  void take(const TopologicalMap& map, const RoomEstimate& estimate);

  /// The place, once it is certain.
  std::optional<PlaceHypothesis> place() const;
  const std::vector<PlaceHypothesis>& hypotheses() const { return hypotheses_; }

 private:
  std::vector<PlaceHypothesis> match(const TopologicalMap& map, const RoomEstimate& estimate) const;
  double door_nats(const TopologicalMap& map, const Room& room, const RoomEstimate& estimate,
                   const Pose2& T_map_zone) const;
  double motion_nats(const PlaceHypothesis& now) const;

  LocaliserConfig config_;
  std::vector<PlaceHypothesis> hypotheses_;  ///< weights: log-probabilities that sum to less than 1
  std::optional<Point2> centre_;             ///< of the last model, zone frame
  double way_m_ = 0.0;                       ///< from the model before
};

}  // namespace enfilade::topo_graph
