// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/optimise/door_residual.hpp"

#include <random>

#include <gtest/gtest.h>

namespace enfilade::topo_graph {
namespace {

/// Central differences of `f` by one room.
template <class F>
RoomJacobian numeric(const RoomVector& at, F f) {
  constexpr double kStep = 1e-6;
  RoomJacobian jacobian;
  for (int i = 0; i < 5; ++i) {
    RoomVector more = at, less = at;
    more[i] += kStep;
    less[i] -= kStep;
    jacobian.col(i) = (f(more) - f(less)) / (2.0 * kStep);
  }
  return jacobian;
}

template <class F>
void expect_analytic_is_numeric(F residual, const RoomVector& a, const RoomVector& b) {
  const Residual at = residual(a, b);
  const RoomJacobian by_a = numeric(a, [&](const RoomVector& v) { return residual(v, b).value; });
  const RoomJacobian by_b = numeric(b, [&](const RoomVector& v) { return residual(a, v).value; });
  EXPECT_LT((at.by_a - by_a).norm(), 1e-6 * (1.0 + by_a.norm()));
  EXPECT_LT((at.by_b - by_b).norm(), 1e-6 * (1.0 + by_b.norm()));
}

RoomVector random_room(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  RoomVector room;
  room << 5.0 * unit(random), 5.0 * unit(random), 3.0 * unit(random), 4.0 + unit(random), 3.0 + unit(random);
  return room;
}

TEST(DoorResidual, HasTheDerivativesOfItsValue) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const int wall_a = trial % 4, wall_b = (trial / 4) % 4;
    const DoorFactor door{.a = {0, wall_a, 0.4, 0.02}, .b = {1, wall_b, -0.3, 0.03}};
    const RoomVector a = random_room(random), b = random_room(random);
    for (const DoorError error : {DoorError::kThickness, DoorError::kPaper})
      expect_analytic_is_numeric(
          [&](const RoomVector& va, const RoomVector& vb) { return door_residual(door, error, va, vb); }, a,
          b);
  }
}

TEST(OdometryResidual, HasTheDerivativesOfItsValue) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 50; ++trial) {
    const OdometryFactor odometry{.to = 1, .T_from_to = {2.0, -1.0, 0.5}};
    const auto residual = [&](const RoomVector& a, const RoomVector& b) {
      return odometry_residual(odometry, a, b);
    };
    expect_analytic_is_numeric(residual, random_room(random), random_room(random));
  }
}

/// Room b east of room a behind a wall of `thickness_m`, the door in the middle of both walls.
RoomVector east_of(double thickness_m) {
  RoomVector b;
  b << 4.0 + thickness_m, 0.0, 0.0, 4.0, 3.0;
  return b;
}
const RoomVector kRoomA = (RoomVector() << 0.0, 0.0, 0.0, 4.0, 3.0).finished();
const DoorFactor kDoor{.a = {.room = 0, .wall = 0}, .b = {.room = 1, .wall = 2}};

TEST(DoorResidual, IsZeroAcrossAWallAsThickAsExpected) {
  EXPECT_LT(door_residual(kDoor, DoorError::kThickness, kRoomA, east_of(0.15)).value.norm(), 1e-12);
  EXPECT_LT(door_residual(kDoor, DoorError::kPaper, kRoomA, east_of(0.0)).value.norm(), 1e-12);
  EXPECT_GT(door_residual(kDoor, DoorError::kPaper, kRoomA, east_of(0.15)).value.norm(), 1.0);
}

// The value hides t: it must be what an explicit search over t ≥ 0 finds.
TEST(DoorResidual, IsTheBestOverAllThicknesses) {
  for (const double gap_m : {-0.2, -0.01, 0.0, 0.003, 0.1, 0.4}) {
    double best = 1e300;
    for (double t = 0.0; t < 1.0; t += 1e-5) {
      const double misfit = (gap_m - t) / kDoor.sigma_position_m;
      const double prior = (t - kDoor.thickness_m) / kDoor.sigma_thickness_m;
      best = std::min(best, misfit * misfit + prior * prior);
    }
    const Residual residual = door_residual(kDoor, DoorError::kThickness, kRoomA, east_of(gap_m));
    EXPECT_NEAR(residual.value.squaredNorm(), best, 1e-4 * (1.0 + best));
    EXPECT_GE(solve_door(kDoor, kRoomA, east_of(gap_m)).thickness_m, 0.0);
  }
}

TEST(DoorSolution, MovesBothFacesTowardsEachOther) {
  RoomVector b = east_of(0.15);
  b[1] = 0.1;  // b's face lies north of a's
  const DoorSolution door = solve_door(kDoor, kRoomA, b);
  EXPECT_GT(door.offset_a_m, 0.0);  // wall 0 runs north
  EXPECT_GT(door.offset_b_m, 0.0);  // wall 2 runs south
  EXPECT_LT(door.offset_a_m + door.offset_b_m, 0.1);
}

TEST(PoseThroughADoor, MeetsTheDoor) {
  DoorFactor door = kDoor;
  door.b = {.room = 1, .wall = 1, .offset_m = 0.7};
  door.turn_rad = 0.02;
  const RoomNode a{{1.0, 2.0, 0.3}, 4.0, 3.0}, b{{}, 5.0, 2.0};
  RoomNode placed = b;
  placed.T_map_room = a.T_map_room * pose_through(door, a, b);
  const auto residual = door_residual(door, DoorError::kThickness, to_vector(a), to_vector(placed));
  EXPECT_LT(residual.value.norm(), 1e-9);
}

}  // namespace
}  // namespace enfilade::topo_graph
