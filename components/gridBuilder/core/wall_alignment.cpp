// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/wall_alignment.hpp"

#include <cmath>

#include <Eigen/Dense>

namespace enfilade::grid_builder {
namespace {

constexpr int kIterations = 12;
constexpr double kLeastInformation = 1e-6;  // of the best known direction
constexpr int kLastIterations = 4;          // with the last gate

/// The wall nearest to a point and how far outside of it the point lies.
struct Sight {
  Point2 normal = Point2::Zero();
  double residual_m = 0.0;
};

std::optional<Sight> nearest_wall(const Point2& p, const Rectangle& walls, double gate_m, double corner_m) {
  const Point2 q = rotate(-walls.yaw_rad, p - walls.pose().translation());
  const Point2 half(0.5 * walls.width_m, 0.5 * walls.height_m);
  const Point2 outside = q.cwiseAbs() - half;
  const int axis = std::abs(outside.x()) < std::abs(outside.y()) ? 0 : 1;
  if (std::abs(outside[axis]) >= gate_m || outside[1 - axis] > -corner_m) return std::nullopt;
  Point2 normal = Point2::Zero();
  normal[axis] = q[axis] > 0.0 ? 1.0 : -1.0;
  return Sight{rotate(walls.yaw_rad, normal), outside[axis]};
}

struct Equations {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d rhs = Eigen::Vector3d::Zero();
  int points = 0;
};

/// Linearised at `moved`, a motion about `pivot`.
Equations equations_of(std::span<const Point2> points, const Rectangle& walls, const Point2& pivot,
                       const Pose2& moved, double gate_m, double corner_m) {
  Equations e;
  for (const Point2& point : points) {
    const Point2 arm = rotate(moved.yaw_rad, point - pivot);
    const auto sight = nearest_wall(pivot + moved.translation() + arm, walls, gate_m, corner_m);
    if (!sight) continue;
    const double t = sight->residual_m / gate_m, weight = (1.0 - t * t) * (1.0 - t * t);
    const Eigen::Vector3d row(sight->normal.x(), sight->normal.y(),
                              sight->normal.dot(Point2(-arm.y(), arm.x())));
    e.normal += weight * row * row.transpose();
    e.rhs -= weight * sight->residual_m * row;
    ++e.points;
  }
  return e;
}

double gate_at(int iteration, const WallAlignmentConfig& config) {
  const double t = std::min(1.0, static_cast<double>(iteration) / (kIterations - kLastIterations));
  return config.first_gate_m * std::pow(config.last_gate_m / config.first_gate_m, t);
}

}  // namespace

std::optional<WallAlignment> align_to_walls(std::span<const Point2> points, const Rectangle& walls,
                                            const Point2& pivot, const WallAlignmentConfig& config) {
  Pose2 moved;
  Equations e;
  int near_walls = 0;
  for (int k = 0; k < kIterations; ++k) {
    e = equations_of(points, walls, pivot, moved, gate_at(k, config), config.corner_m);
    if (k == 0) near_walls = e.points;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(e.normal);
    const Eigen::Vector3d& information = solver.eigenvalues();  // rising
    if (!(information[0] > kLeastInformation * information[2])) return std::nullopt;
    const Eigen::Vector3d step = e.normal.ldlt().solve(e.rhs);
    moved = {moved.x_m + step.x(), moved.y_m + step.y(), moved.yaw_rad + step.z()};
  }
  const Eigen::Matrix3d covariance = config.sigma_m * config.sigma_m * e.normal.inverse();
  const Eigen::Vector2d spread =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance.topLeftCorner<2, 2>()).eigenvalues();
  const Point2 t = pivot + moved.translation() - rotate(moved.yaw_rad, pivot);
  return WallAlignment{.T_after_before = {t.x(), t.y(), moved.yaw_rad},
                       .sigma_m = std::sqrt(spread.maxCoeff()),
                       .sigma_rad = std::sqrt(covariance(2, 2)),
                       .on_walls_share = near_walls > 0 ? static_cast<double>(e.points) / near_walls : 0.0};
}

}  // namespace enfilade::grid_builder
