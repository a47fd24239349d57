// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/room_model.hpp"

#include <Eigen/Core>

namespace enfilade::topo_graph {
namespace {

using Matrix5 = Eigen::Matrix<double, 5, 5, Eigen::RowMajor>;

/// The centre turns with the frame; width and height change places with every odd quarter turn.
RectangleCovariance turned(const RectangleCovariance& covariance, double yaw_rad, int quarter_turns) {
  Matrix5 J = Matrix5::Identity();
  J.block<2, 1>(1, 1) = rotate(yaw_rad, {1.0, 0.0});
  J.block<2, 1>(1, 2) = rotate(yaw_rad, {0.0, 1.0});
  if (quarter_turns % 2 != 0) J.row(3).swap(J.row(4));
  const Matrix5 result = J * Eigen::Map<const Matrix5>(covariance.data()) * J.transpose();
  RectangleCovariance out;
  Eigen::Map<Matrix5>(out.data()) = result;
  return out;
}

}  // namespace

WallInterval renamed(WallInterval gap, int quarter_turns) {
  gap.wall = static_cast<std::uint8_t>((gap.wall + quarter_turns) % 4);
  return gap;
}

RoomModel room_model(const RoomEstimate& estimate, const Pose2& T_map_zone) {
  const auto [rectangle, quarter_turns] = canonical(T_map_zone * estimate.rectangle);
  RoomModel model;
  model.quarter_turns = quarter_turns;
  model.room.T_map_room = rectangle.pose();  // eq. 17
  model.room.width_m = rectangle.width_m;
  model.room.height_m = rectangle.height_m;
  if (estimate.covariance)
    model.room.covariance = turned(*estimate.covariance, T_map_zone.yaw_rad, quarter_turns);
  const Pose2 T_room_zone = model.room.T_map_room.inverse() * T_map_zone;
  for (const Point2& p_zone : estimate.polygon) model.room.polygon.push_back(T_room_zone * p_zone);
  model.room.zone_id = estimate.tag.zone_id;
  model.room.fixed_ns = estimate.stamp_ns;
  for (DoorEstimate door : estimate.doors) {
    if (door.state != DoorState::kOpen) continue;
    door.gap = renamed(door.gap, quarter_turns);
    model.doors.push_back(door);
  }
  return model;
}

}  // namespace enfilade::topo_graph
