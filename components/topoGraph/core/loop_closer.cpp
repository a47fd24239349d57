// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/loop_closer.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/LU>

#include "components/topoGraph/core/optimise/marginals.hpp"
#include "interfaces/geometry/square.hpp"

namespace enfilade::topo_graph {
namespace {

double log_normal(const Eigen::Vector3d& off, const Eigen::Matrix3d& covariance) {
  const double determinant = (2.0 * kPi * covariance).determinant();
  return -0.5 * off.dot(covariance.inverse() * off) - 0.5 * std::log(determinant);
}

/// How far one of the rooms would have to be moved, along its own axes, for the two not to overlap.
double overlap_depth(const Rectangle& a, const Rectangle& b) {
  const Point2 apart = rotate(-a.yaw_rad, b.pose().translation() - a.pose().translation());
  const bool across = std::abs(std::sin(b.yaw_rad - a.yaw_rad)) > 0.5;
  const double width_m = across ? b.height_m : b.width_m, height_m = across ? b.width_m : b.height_m;
  const double x = 0.5 * (a.width_m + width_m) - std::abs(apart.x());
  const double y = 0.5 * (a.height_m + height_m) - std::abs(apart.y());
  return std::max(0.0, std::min(x, y));
}

/// The gap of the model as the stored room's walls would show it.
WallInterval onto(const Room& room, const Room& model, const Pose2& T_room_model, const WallInterval& gap) {
  PlacedFace face = place(model.rectangle(), gap);
  const Pose2 T = room.T_map_room * T_room_model * model.T_map_room.inverse();
  face.segment = T * face.segment;
  face.normal = rotate(T.yaw_rad, face.normal);
  return project_on_nearest_wall({face.segment, -face.normal}, room.rectangle(), 0.5);
}

struct StoredDoor {
  const Door* door = nullptr;
  const DoorFace* face = nullptr;
};

std::vector<StoredDoor> doors_of(const TopologicalMap& map, RoomId room) {
  std::vector<StoredDoor> doors;
  for (const Door& door : map.doors) {
    if (const DoorFace* face = TopologicalMap::find_face(door, room)) doors.push_back({&door, face});
  }
  return doors;
}

const StoredDoor* nearest(const std::vector<StoredDoor>& doors, const WallInterval& gap, double within_m) {
  const StoredDoor* best = nullptr;
  for (const StoredDoor& stored : doors) {
    const double away = std::abs(stored.face->gap.middle_m() - gap.middle_m());
    if (stored.face->gap.wall != gap.wall || away > within_m) continue;
    within_m = away;
    best = &stored;
  }
  return best;
}

}  // namespace

LoopCloser::LoopCloser(const LoopCloserConfig& config, const UncertaintyConfig& uncertainty)
    : config_(config), uncertainty_(uncertainty) {
  if (config.gate_sigma <= 0.0 || config.space_m2 <= 0.0 || config.accept_nats < 0.0 ||
      config.margin_nats < 0.0)
    throw std::invalid_argument("LoopCloser: gate and space must be positive, thresholds not negative");
}

Eigen::Matrix3d LoopCloser::step_covariance(double way_m, bool through_door) const {
  const UncertaintyConfig& u = uncertainty_;
  const double yaw = through_door ? u.door_direction_rad : u.odometry_yaw_rad;
  const double position = through_door ? std::hypot(u.door_position_m, u.door_position_m, u.thickness_sigma_m)
                                       : u.odometry_share * way_m + u.odometry_m;
  const double swung = 0.5 * way_m * yaw;  // the door's turn moves the room's centre
  return Eigen::Vector3d(square(position) + square(swung), square(position) + square(swung), square(yaw))
      .asDiagonal();
}

std::optional<SameRoom> LoopCloser::find(const TopologicalMap& map, const Prediction& prediction) const {
  std::vector<SameRoom> candidates = score(map, prediction);
  std::sort(candidates.begin(), candidates.end(),
            [](const SameRoom& a, const SameRoom& b) { return a.nats > b.nats; });
  if (candidates.empty() || candidates[0].nats < config_.accept_nats) return std::nullopt;
  if (candidates.size() > 1 && candidates[0].nats - candidates[1].nats < config_.margin_nats)
    return std::nullopt;
  return candidates[0];
}

/// Each stored room that passes the gates, under its likeliest naming.
std::vector<SameRoom> LoopCloser::score(const TopologicalMap& map, const Prediction& prediction) const {
  std::vector<SameRoom> candidates;
  std::optional<Marginals> marginals;
  const Room& seen = prediction.model.room;
  for (std::size_t i = 0; i < map.rooms.size(); ++i) {
    const Room& room = map.rooms[i];
    const double away = (room.T_map_room.translation() - seen.T_map_room.translation()).norm();
    if (away > config_.search_m) continue;
    if (room.id == prediction.from_room && !overlaps(room, seen)) continue;
    if (!overlaps(room, seen) && !size_nats(room, seen, false) && !size_nats(room, seen, true)) continue;
    if (!marginals) {
      const MapProblem problem = map_problem(map, uncertainty_);
      marginals.emplace(problem.problem, problem.problem.rooms, SolverConfig{});
    }
    // In the frame of the room behind, or of the map where there is none.
    const auto from = prediction.from_room ? room_index(map, *prediction.from_room) : std::nullopt;
    Eigen::Matrix3d covariance = from ? marginals->relative_pose(*from, i) : marginals->pose(i);
    covariance += prediction.covariance;
    if (from) {
      Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
      R.block<2, 1>(0, 0) = rotate(map.rooms[*from].T_map_room.yaw_rad, {1.0, 0.0});
      R.block<2, 1>(0, 1) = rotate(map.rooms[*from].T_map_room.yaw_rad, {0.0, 1.0});
      covariance = (R * covariance * R.transpose()).eval();
    }
    std::optional<SameRoom> best;
    for (int quarter = 0; quarter < 4; ++quarter) {
      const Pose2 T_map_seen = seen.T_map_room * Pose2{0.0, 0.0, 0.5 * kPi * quarter};
      const auto scored = score_naming(map, room, prediction, T_map_seen, covariance);
      if (scored && (!best || scored->nats > best->nats)) best = scored;
    }
    if (best) candidates.push_back(*best);
  }
  return candidates;
}

std::optional<SameRoom> LoopCloser::score_naming(const TopologicalMap& map, const Room& room,
                                                 const Prediction& prediction, const Pose2& T_map_seen,
                                                 const Eigen::Matrix3d& covariance) const {
  const Room& seen = prediction.model.room;
  const double turn = T_map_seen.yaw_rad - seen.T_map_room.yaw_rad;
  const Eigen::Vector3d off(T_map_seen.x_m - room.T_map_room.x_m, T_map_seen.y_m - room.T_map_room.y_m,
                            wrap_to_pi(T_map_seen.yaw_rad - room.T_map_room.yaw_rad));
  const bool turned = std::abs(std::sin(turn)) > 0.5;
  const bool covers = overlaps(room, seen) && std::abs(off[2]) < 0.5;
  // 3σ of three dimensions is 3.8σ of one.
  const bool in_gate = off.dot(covariance.inverse() * off) <= square(config_.gate_sigma) + 5.2;
  auto sizes = size_nats(room, seen, turned);
  if (!sizes && covers) sizes = -config_.other_size_nats;
  if (!in_gate && !covers) return std::nullopt;
  const Pose2 T_room_model{0.0, 0.0, wrap_to_pi(-turn)};
  const auto doors = door_nats(map, room, prediction, T_room_model);
  if (!sizes || !doors) return std::nullopt;
  // A new room cannot overlap a stored one: it would have to be elsewhere than predicted.
  const double sigma = std::sqrt(std::max(1e-4, covariance.topLeftCorner<2, 2>().trace() * 0.5));
  const double depth = std::max(0.0, overlap_depth(room.rectangle(), seen.rectangle()) - 0.1);
  const double log_new = -std::log(config_.space_m2 * 0.5 * kPi) - 0.5 * square(depth / sigma);
  return SameRoom{.room = room.id,
                  .nats = log_normal(off, covariance) - log_new + *sizes + *doors,
                  .T_map_model = room.T_map_room * T_room_model};
}

bool LoopCloser::overlaps(const Room& room, const Room& seen) const {
  return iou(room.rectangle(), seen.rectangle()) > config_.overlap_iou;
}

/// Equal sizes say little, for rooms come in series; different ones exclude.
std::optional<double> LoopCloser::size_nats(const Room& room, const Room& seen, bool turned) const {
  const double width_m = turned ? seen.height_m : seen.width_m,
               height_m = turned ? seen.width_m : seen.height_m;
  const double sigma = std::sqrt(2.0) * uncertainty_.size_m;
  const double w = (width_m - room.width_m) / sigma, h = (height_m - room.height_m) / sigma;
  if (std::abs(w) > config_.gate_sigma || std::abs(h) > config_.gate_sigma) return std::nullopt;
  return -0.5 * (square(w) + square(h));
}

std::optional<double> LoopCloser::door_nats(const TopologicalMap& map, const Room& room,
                                            const Prediction& prediction, const Pose2& T_room_model) const {
  const std::vector<StoredDoor> stored = doors_of(map, room.id);
  const RoomModel& model = prediction.model;
  std::vector<const StoredDoor*> met;
  double nats = 0.0;
  const auto look_up = [&](const WallInterval& gap) {
    const StoredDoor* door = nearest(stored, onto(room, model.room, T_room_model, gap), config_.door_match_m);
    if (door) met.push_back(door);
    return door;
  };
  if (prediction.entrance) {
    // A door has one other side: where the stored room's leads elsewhere, this is another room.
    const StoredDoor* door = look_up(*prediction.entrance);
    if (room.id != prediction.from_room && door && door->door->other_face &&
        door->door->id != prediction.via_door)
      return std::nullopt;
    if (!door) nats -= config_.extra_door_nats;
    if (door && !door->door->other_face) nats += config_.open_door_nats;
  }
  for (const DoorEstimate& door : model.doors)
    if (!(prediction.entrance && door.gap == *prediction.entrance) && !look_up(door.gap))
      nats -= config_.extra_door_nats;
  for (const StoredDoor& door : stored) {
    const bool seen =
        std::any_of(met.begin(), met.end(), [&](const StoredDoor* m) { return m->door == door.door; });
    if (!seen) nats -= config_.missing_door_nats;
  }
  return nats;
}

}  // namespace enfilade::topo_graph
