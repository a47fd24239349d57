// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/optimise/door_residual.hpp"

#include <cmath>

#include "interfaces/geometry/square.hpp"

namespace enfilade::topo_graph {
namespace {

using Vector2 = Eigen::Vector2d;
using PointJacobian = Eigen::Matrix<double, 2, 5>;

Vector2 left_of(const Vector2& v) { return {-v.y(), v.x()}; }

/// v turned by whole quarters, exactly.
Vector2 quarter_turned(Vector2 v, int quarters) {
  for (int i = 0; i < quarters; ++i) v = left_of(v);
  return v;
}

/// T_map_room·d with its derivative, and the wall's outward normal.
struct Face {
  Vector2 point;
  Vector2 normal;
  PointJacobian by_room;
};

Face place(const FaceNode& face, const RoomVector& room) {
  const int size = face.wall % 2 == 0 ? 3 : 4;  // w moves walls 0 and 2, h walls 1 and 3
  const double cosine = std::cos(room[2]), sine = std::sin(room[2]);
  Eigen::Matrix2d R;
  R << cosine, -sine, sine, cosine;
  const Vector2 arm = R * quarter_turned({0.5 * room[size], face.offset_m}, face.wall);
  Face placed{room.head<2>() + arm, R * quarter_turned({1.0, 0.0}, face.wall), PointJacobian::Zero()};
  placed.by_room.leftCols<2>().setIdentity();
  placed.by_room.col(2) = left_of(arm);
  placed.by_room.col(size) = 0.5 * placed.normal;
  return placed;
}

double turn(const DoorFactor& door, const RoomVector& a, const RoomVector& b) {
  return wrap_to_pi(b[2] - a[2] + 0.5 * kPi * (door.b.wall - door.a.wall) - kPi - door.turn_rad);
}

double variance_along(const DoorFactor& door) {
  return square(door.sigma_position_m) + square(door.a.sigma_offset_m) + square(door.b.sigma_offset_m);
}

double best_thickness(const DoorFactor& door, double across_m) {
  const double position = square(door.sigma_position_m), prior = square(door.sigma_thickness_m);
  return std::max(0.0, (across_m * prior + door.thickness_m * position) / (position + prior));
}

/// min over t ≥ 0 of ((across − t)/σ)² + ((t − t₀)/σ_t)², as the square of a residual.
struct Across {
  double value = 0.0;
  double derivative = 0.0;
};

Across across_residual(const DoorFactor& door, double across_m) {
  if (best_thickness(door, across_m) > 0.0) {
    const double inverse_sigma = 1.0 / std::hypot(door.sigma_position_m, door.sigma_thickness_m);
    return {(across_m - door.thickness_m) * inverse_sigma, inverse_sigma};
  }
  const double value =
      -std::hypot(across_m / door.sigma_position_m, door.thickness_m / door.sigma_thickness_m);
  return {value, across_m / (square(door.sigma_position_m) * value)};
}

}  // namespace

RoomVector to_vector(const RoomNode& room) {
  RoomVector v;
  v << room.T_map_room.x_m, room.T_map_room.y_m, room.T_map_room.yaw_rad, room.width_m, room.height_m;
  return v;
}

void from_vector(const RoomVector& v, RoomNode& room) {
  room.T_map_room = {v[0], v[1], wrap_to_pi(v[2])};
  room.width_m = v[3];
  room.height_m = v[4];
}

FaceGap face_gap(const DoorFactor& door, const RoomVector& a, const RoomVector& b) {
  const Face face_a = place(door.a, a);
  const Vector2 gap = place(door.b, b).point - face_a.point;
  return {left_of(face_a.normal).dot(gap), face_a.normal.dot(gap), turn(door, a, b)};
}

Residual door_residual(const DoorFactor& door, DoorError error, const RoomVector& a, const RoomVector& b) {
  const Face face_a = place(door.a, a), face_b = place(door.b, b);
  const Vector2 gap = face_b.point - face_a.point;
  Residual residual;
  if (error == DoorError::kPaper) {  // eq. 21: ‖T_ri·d_ri − T_rj·d_rj‖²
    residual.value.head<2>() = gap / door.sigma_position_m;
    residual.by_a.topRows<2>() = -face_a.by_room / door.sigma_position_m;
    residual.by_b.topRows<2>() = face_b.by_room / door.sigma_position_m;
    return residual;
  }
  const Vector2 normal = face_a.normal, along = left_of(normal);
  const double inverse_along = 1.0 / std::sqrt(variance_along(door));
  const Across across = across_residual(door, normal.dot(gap));
  residual.value = {along.dot(gap) * inverse_along, across.value,
                    turn(door, a, b) / door.sigma_direction_rad};
  residual.by_a.row(0) = -along.transpose() * face_a.by_room;
  residual.by_a(0, 2) -= normal.dot(gap);
  residual.by_a.row(1) = -normal.transpose() * face_a.by_room;
  residual.by_a(1, 2) += along.dot(gap);
  residual.by_b.row(0) = along.transpose() * face_b.by_room;
  residual.by_b.row(1) = normal.transpose() * face_b.by_room;
  for (RoomJacobian* jacobian : {&residual.by_a, &residual.by_b}) {
    jacobian->row(0) *= inverse_along;
    jacobian->row(1) *= across.derivative;
  }
  residual.by_a(2, 2) = -1.0 / door.sigma_direction_rad;
  residual.by_b(2, 2) = 1.0 / door.sigma_direction_rad;
  return residual;
}

DoorSolution solve_door(const DoorFactor& door, const RoomVector& a, const RoomVector& b) {
  const FaceGap gap = face_gap(door, a, b);
  // b's wall runs against a's: a shift of either face the way its own wall runs shortens a positive gap.
  const double share = gap.along_m / variance_along(door);
  return {.thickness_m = best_thickness(door, gap.across_m),
          .offset_a_m = door.a.offset_m + square(door.a.sigma_offset_m) * share,
          .offset_b_m = door.b.offset_m + square(door.b.sigma_offset_m) * share};
}

Pose2 pose_through(const DoorFactor& door, const RoomNode& a, const RoomNode& b) {
  const auto face_pose = [](const FaceNode& face, const RoomNode& room, double beyond_m) {
    const double half = 0.5 * (face.wall % 2 == 0 ? room.width_m : room.height_m);
    const Vector2 point = quarter_turned({half + beyond_m, face.offset_m}, face.wall);
    return Pose2{point.x(), point.y(), 0.5 * kPi * face.wall};
  };
  const Pose2 T_a_door = face_pose(door.a, a, door.thickness_m);
  const Pose2 T_b_door = face_pose(door.b, b, 0.0);
  return T_a_door * Pose2{0.0, 0.0, kPi + door.turn_rad} * T_b_door.inverse();
}

Residual odometry_residual(const OdometryFactor& odometry, const RoomVector& from, const RoomVector& to) {
  const double cosine = std::cos(from[2]), sine = std::sin(from[2]);
  Eigen::Matrix2d R_inverse;
  R_inverse << cosine, sine, -sine, cosine;
  const Vector2 there = R_inverse * (to.head<2>() - from.head<2>());
  const double inverse_position = 1.0 / odometry.sigma_position_m, inverse_yaw = 1.0 / odometry.sigma_yaw_rad;
  Residual residual;
  residual.value.head<2>() = (there - odometry.T_from_to.translation()) * inverse_position;
  residual.value[2] = wrap_to_pi(to[2] - from[2] - odometry.T_from_to.yaw_rad) * inverse_yaw;
  residual.by_a.topLeftCorner<2, 2>() = -R_inverse * inverse_position;
  residual.by_a.block<2, 1>(0, 2) = -left_of(there) * inverse_position;
  residual.by_a(2, 2) = -inverse_yaw;
  residual.by_b.topLeftCorner<2, 2>() = R_inverse * inverse_position;
  residual.by_b(2, 2) = inverse_yaw;
  return residual;
}

}  // namespace enfilade::topo_graph
