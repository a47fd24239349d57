// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/localiser.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "components/topoGraph/core/pose_tracker.hpp"

namespace enfilade::topo_graph {
namespace {

double square(double value) { return value * value; }

/// ln(eᵃ + eᵇ).
double log_sum(double a, double b) {
  const double larger = std::max(a, b);
  return larger + std::log1p(std::exp(std::min(a, b) - larger));
}

}  // namespace

Localiser::Localiser(const LocaliserConfig& config) : config_(config) {
  if (config.size_sigma_m <= 0.0 || config.door_sigma_m <= 0.0 || config.motion_sigma_m <= 0.0 ||
      config.motion_sigma_rad <= 0.0 || config.certain <= 0.5 || config.certain >= 1.0)
    throw std::invalid_argument("Localiser: sigmas must be positive, certain in (0.5, 1)");
}

void Localiser::take(const TopologicalMap& map, const RoomEstimate& estimate) {
  if (!estimate.found) return;
  const Point2 centre = estimate.rectangle.pose().translation();
  way_m_ = centre_ ? (centre - *centre_).norm() : 0.0;
  std::vector<PlaceHypothesis> next = match(map, estimate);
  for (PlaceHypothesis& hypothesis : next) hypothesis.log_weight += motion_nats(hypothesis);
  double total = -config_.elsewhere_nats;
  for (const PlaceHypothesis& hypothesis : next) total = log_sum(total, hypothesis.log_weight);
  for (PlaceHypothesis& hypothesis : next) hypothesis.log_weight -= total;
  std::erase_if(next, [](const PlaceHypothesis& h) { return h.log_weight < -20.0; });
  std::sort(next.begin(), next.end(),
            [](const PlaceHypothesis& a, const PlaceHypothesis& b) { return a.log_weight > b.log_weight; });
  hypotheses_ = std::move(next);
  centre_ = centre;
}

std::optional<PlaceHypothesis> Localiser::place() const {
  if (hypotheses_.empty() || hypotheses_.front().log_weight < std::log(config_.certain)) return std::nullopt;
  return hypotheses_.front();
}

std::vector<PlaceHypothesis> Localiser::match(const TopologicalMap& map, const RoomEstimate& estimate) const {
  std::vector<PlaceHypothesis> out;
  for (const Room& room : map.rooms) {
    for (const Pose2& T_zone_room :
         namings(room.rectangle(), estimate.rectangle, 4.0 * config_.size_sigma_m)) {
      const bool turned = std::abs(std::sin(T_zone_room.yaw_rad - estimate.rectangle.yaw_rad)) > 0.5;
      const double width_m = turned ? estimate.rectangle.height_m : estimate.rectangle.width_m;
      const double height_m = turned ? estimate.rectangle.width_m : estimate.rectangle.height_m;
      const double misfit = square(width_m - room.width_m) + square(height_m - room.height_m);
      PlaceHypothesis hypothesis{.room = room.id, .T_map_zone = room.T_map_room * T_zone_room.inverse()};
      hypothesis.log_weight = -0.5 * misfit / square(config_.size_sigma_m) +
                              door_nats(map, room, estimate, hypothesis.T_map_zone);
      out.push_back(hypothesis);
    }
  }
  return out;
}

double Localiser::door_nats(const TopologicalMap& map, const Room& room, const RoomEstimate& estimate,
                            const Pose2& T_map_zone) const {
  std::vector<Point2> stored;
  for (const Door& door : map.doors)
    if (const DoorFace* face = TopologicalMap::find_face(door, room.id))
      stored.push_back(segment_in_map(room, *face).midpoint());
  double nats = 0.0;
  std::size_t met = 0;
  for (const DoorEstimate& door : estimate.doors) {
    if (door.state != DoorState::kOpen) continue;
    const Point2 middle = T_map_zone * segment_of(estimate.rectangle, door.gap).midpoint();
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point2& there : stored) nearest = std::min(nearest, (there - middle).norm());
    const double misfit = 0.5 * square(nearest / config_.door_sigma_m);
    if (misfit < config_.missing_door_nats) ++met;
    nats -= std::min(misfit, config_.missing_door_nats);
  }
  return nats - config_.missing_door_nats * static_cast<double>(stored.size() - std::min(met, stored.size()));
}

/// Odometry holds between two models: a hypothesis goes on from one that turns and shifts the zone alike.
double Localiser::motion_nats(const PlaceHypothesis& now) const {
  if (hypotheses_.empty() || !centre_) return 0.0;
  const double sigma_m = config_.motion_sigma_m + config_.motion_share * way_m_;
  double nats = -config_.elsewhere_nats;
  for (const PlaceHypothesis& before : hypotheses_) {
    const Point2 shift = now.T_map_zone * *centre_ - before.T_map_zone * *centre_;
    const double turn = wrap_to_pi(now.T_map_zone.yaw_rad - before.T_map_zone.yaw_rad);
    const double misfit =
        0.5 * (shift.squaredNorm() / square(sigma_m) + square(turn / config_.motion_sigma_rad));
    nats = log_sum(nats, before.log_weight - misfit);
  }
  return nats;
}

}  // namespace enfilade::topo_graph
