// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/graph/synthetic_graph.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "components/topoGraph/core/optimise/door_residual.hpp"
#include "tools/evaluate/graph/building_plan.hpp"

namespace enfilade::evaluate {
namespace {

using topo_graph::DoorFactor;
using topo_graph::FaceNode;
using topo_graph::OdometryFactor;
using topo_graph::RoomNode;

constexpr double kThicknessM = 0.15;

class GraphMaker {
 public:
  explicit GraphMaker(const SyntheticSpec& spec) : spec_(spec), random_(spec.seed) {}

  SyntheticGraph make() {
    const BuildingPlan plan = make_plan(spec_, random_);
    for (const Cell& cell : plan.cells) add_room(cell);
    graph_.truth[0].T_map_room = {};
    graph_.problem.rooms[0].T_map_room = {};
    for (const Passage& passage : plan.driven) {
      add_odometry(passage);
      add_door(passage, false);
    }
    for (const Passage& passage : plan.loops) add_door(passage, true);
    graph_.loops = static_cast<int>(plan.loops.size());
    for (int i = 0; i < spec_.false_doors; ++i) add_false_door(plan, i % 2 == 0);
    return std::move(graph_);
  }

 private:
  double normal(double sigma) { return sigma * std::normal_distribution<double>()(random_); }
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  std::size_t index(std::size_t size) { return random_() % size; }

  /// Each wall takes its own share of the thickness, so that the thickness of every door is drawn from the
  /// prior.
  void add_room(const Cell& cell) {
    std::array<double, 4> taken{};
    for (double& share : taken)
      share = std::max(0.0, 0.5 * kThicknessM + normal(spec_.noise.thickness_m / std::sqrt(2.0)));
    const bool first = graph_.truth.empty();
    if (first)
      origin_ = {cell.x_m + 0.5 * (taken[2] - taken[0]), cell.y_m + 0.5 * (taken[3] - taken[1]), 0.0};
    const Pose2 pose{cell.x_m + 0.5 * (taken[2] - taken[0]) - origin_.x_m,
                     cell.y_m + 0.5 * (taken[3] - taken[1]) - origin_.y_m,
                     first ? 0.0 : normal(spec_.noise.crooked_rad)};
    const RoomNode truth{pose, cell.width_m - taken[0] - taken[2], cell.height_m - taken[1] - taken[3],
                         spec_.noise.size_m, spec_.noise.size_m};
    graph_.truth.push_back(truth);
    RoomNode measured = truth;
    measured.width_m += normal(spec_.noise.size_m);
    measured.height_m += normal(spec_.noise.size_m);
    graph_.problem.rooms.push_back(measured);
  }

  void add_odometry(const Passage& passage) {
    const Pose2 T_a_b = graph_.truth[passage.a].T_map_room.inverse() * graph_.truth[passage.b].T_map_room;
    OdometryFactor odometry{.from = passage.a, .to = passage.b};
    odometry.sigma_position_m = spec_.noise.odometry_share * T_a_b.translation().norm();
    odometry.sigma_yaw_rad = spec_.noise.odometry_yaw_rad;
    odometry.T_from_to = {T_a_b.x_m + normal(odometry.sigma_position_m),
                          T_a_b.y_m + normal(odometry.sigma_position_m),
                          wrap_to_pi(T_a_b.yaw_rad + normal(odometry.sigma_yaw_rad))};
    graph_.problem.odometry.push_back(odometry);
    std::vector<RoomNode>& rooms = graph_.problem.rooms;
    rooms[passage.b].T_map_room = rooms[passage.a].T_map_room * odometry.T_from_to;
  }

  DoorFactor door_between(std::size_t a, int wall, std::size_t b, bool loop) {
    DoorFactor door{.a = {a, wall, 0.0, spec_.noise.offset_m},
                    .b = {b, (wall + 2) % 4, 0.0, spec_.noise.offset_m}};
    door.thickness_m = kThicknessM;
    door.sigma_thickness_m = spec_.noise.thickness_m;
    door.sigma_direction_rad = spec_.noise.direction_rad;
    door.loop = loop;
    return door;
  }

  void add_door(const Passage& passage, bool loop) {
    DoorFactor door = door_between(passage.a, passage.wall, passage.b, loop);
    const RoomNode &a = graph_.truth[passage.a], &b = graph_.truth[passage.b];
    const double length_m =
        passage.wall % 2 == 0 ? std::min(a.height_m, b.height_m) : std::min(a.width_m, b.width_m);
    door.a.offset_m = uniform(-0.5, 0.5) * std::max(0.0, length_m - 1.2);
    // The other face is where the normal of a's wall through the door meets b's wall.
    const auto va = topo_graph::to_vector(a), vb = topo_graph::to_vector(b);
    for (int i = 0; i < 3; ++i) door.b.offset_m += topo_graph::face_gap(door, va, vb).along_m;
    const topo_graph::FaceGap gap = topo_graph::face_gap(door, va, vb);
    door.turn_rad = gap.turn_rad + normal(spec_.noise.direction_rad);
    door.a.offset_m += normal(spec_.noise.offset_m);
    door.b.offset_m += normal(spec_.noise.offset_m);
    graph_.problem.doors.push_back(door);
  }

  void add_false_door(const BuildingPlan& plan, bool near) {
    const auto away = [&](std::size_t a, std::size_t b) {
      return std::hypot(plan.cells[a].x_m - plan.cells[b].x_m, plan.cells[a].y_m - plan.cells[b].y_m);
    };
    for (;;) {
      const std::size_t a = index(plan.cells.size()), b = index(plan.cells.size());
      if (a == b || (near && away(a, b) > 10.0) || away(a, b) < 5.0) continue;
      DoorFactor door = door_between(a, static_cast<int>(index(4)), b, true);
      door.a.offset_m = uniform(-1.0, 1.0);
      door.b.offset_m = uniform(-1.0, 1.0);
      graph_.problem.doors.push_back(door);
      return;
    }
  }

  SyntheticSpec spec_;
  std::mt19937_64 random_;
  SyntheticGraph graph_;
  Pose2 origin_;
};

}  // namespace

SyntheticGraph make_graph(const SyntheticSpec& spec) { return GraphMaker(spec).make(); }

double position_rmse_m(const std::vector<RoomNode>& rooms, const std::vector<RoomNode>& truth) {
  double sum = 0.0;
  for (std::size_t i = 0; i < rooms.size(); ++i)
    sum += (rooms[i].T_map_room.translation() - truth[i].T_map_room.translation()).squaredNorm();
  return std::sqrt(sum / static_cast<double>(rooms.size()));
}

}  // namespace enfilade::evaluate
