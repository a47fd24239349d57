// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/wall_alignment.hpp"

#include <cmath>

#include <Eigen/Dense>

namespace enfilade::grid_builder {
namespace {

constexpr int kIterations = 12;
constexpr int kLastIterations = 4;   // with the last gate
constexpr double kTurnStep = 0.026;  // 1.5°: the first gate catches more than half of it
constexpr std::size_t kPointsToSearch = 800;

/// The wall nearest to a point and how far outside of it the point lies.
struct Sight {
  Point2 normal = Point2::Zero();
  double residual_m = 0.0;
};

std::optional<Sight> nearest_wall(const Point2& p, const KnownWalls& walls, double gate_m, double corner_m) {
  const Rectangle& r = walls.rectangle;
  const Point2 q = rotate(-r.yaw_rad, p - r.pose().translation());
  const Point2 half(0.5 * r.width_m, 0.5 * r.height_m);
  const Point2 outside = q.cwiseAbs() - half;
  const int axis = std::abs(outside.x()) < std::abs(outside.y()) ? 0 : 1;
  if (std::abs(outside[axis]) >= gate_m || outside[1 - axis] > -corner_m) return std::nullopt;
  const bool is_far_side = q[axis] > 0.0;
  if (!walls.seen[static_cast<std::size_t>(axis + (is_far_side ? 0 : 2))]) return std::nullopt;
  Point2 normal = Point2::Zero();
  normal[axis] = is_far_side ? 1.0 : -1.0;
  return Sight{rotate(r.yaw_rad, normal), outside[axis]};
}

/// Tukey's weight of a residual, in gates.
double tukey(double t) { return (1.0 - t * t) * (1.0 - t * t); }

struct Equations {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d rhs = Eigen::Vector3d::Zero();
  int points = 0;
};

/// Linearised at `moved`, a motion about `pivot`.
Equations equations_of(std::span<const Point2> points, const KnownWalls& walls, const Point2& pivot,
                       const Pose2& moved, double gate_m, double corner_m) {
  Equations e;
  for (const Point2& point : points) {
    const Point2 arm = rotate(moved.yaw_rad, point - pivot);
    const auto sight = nearest_wall(pivot + moved.translation() + arm, walls, gate_m, corner_m);
    if (!sight) continue;
    const double weight = tukey(sight->residual_m / gate_m);
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

/// The turn about `pivot` from which to begin: the one that brings most points near to walls.
double first_turn(std::span<const Point2> points, const KnownWalls& walls, const Point2& pivot,
                  const WallAlignmentConfig& config) {
  const int steps =
      config.search_rad <= kTurnStep ? 0 : static_cast<int>(std::ceil(config.search_rad / kTurnStep));
  const std::size_t every = 1 + points.size() / kPointsToSearch;
  double best_turn = 0.0, best = -1.0;
  // From the middle outwards, so that a tie goes to odometry.
  for (int i = 0; i <= 2 * steps; ++i) {
    const double turn = kTurnStep * ((i + 1) / 2) * (i % 2 == 0 ? 1.0 : -1.0);
    double near = 0.0;
    for (std::size_t k = 0; k < points.size(); k += every) {
      const Point2 p = pivot + rotate(turn, points[k] - pivot);
      const auto sight = nearest_wall(p, walls, config.first_gate_m, config.corner_m);
      if (sight) near += tukey(sight->residual_m / config.first_gate_m);
    }
    if (near <= best) continue;
    best = near;
    best_turn = turn;
  }
  return best_turn;
}

}  // namespace

std::optional<WallAlignment> align_to_walls(std::span<const Point2> points, const KnownWalls& walls,
                                            const Point2& pivot, const WallAlignmentConfig& config) {
  Pose2 moved{0.0, 0.0, first_turn(points, walls, pivot, config)};
  Equations e;
  int near_walls = 0;
  for (int k = 0; k < kIterations; ++k) {
    e = equations_of(points, walls, pivot, moved, gate_at(k, config), config.corner_m);
    if (k == 0) near_walls = e.points;
    if (e.points == 0) return std::nullopt;
    e.normal += config.sigma_m * config.sigma_m * Eigen::Matrix3d::Identity();  // known to a metre
    const Eigen::Vector3d step = e.normal.ldlt().solve(e.rhs);
    moved = {moved.x_m + step.x(), moved.y_m + step.y(), moved.yaw_rad + step.z()};
  }
  const Eigen::Matrix3d covariance = config.sigma_m * config.sigma_m * e.normal.inverse();
  const Eigen::Matrix2d of_place = covariance.topLeftCorner<2, 2>();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  const Eigen::Vector2d spread = solver.computeDirect(of_place, Eigen::EigenvaluesOnly).eigenvalues();
  const Point2 t = pivot + moved.translation() - rotate(moved.yaw_rad, pivot);
  return WallAlignment{.T_after_before = {t.x(), t.y(), moved.yaw_rad},
                       .covariance = covariance,
                       .sigma_m = std::sqrt(spread.maxCoeff()),
                       .sigma_rad = std::sqrt(covariance(2, 2)),
                       .on_walls_share = static_cast<double>(e.points) / near_walls};
}

}  // namespace enfilade::grid_builder
