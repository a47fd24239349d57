// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/joint_fit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "components/roomDetector/core/wall_equations.hpp"

namespace enfilade::room_detector {
namespace {

constexpr int kJointIterations = 6;
constexpr double kLeastSigma_m = 0.003;  // of one return; a perfect simulation would make it zero
constexpr double kTogether_m = 0.06;     // walls of aligned stands lie so near

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

Point2 left_of(const Point2& v) { return {-v.y(), v.x()}; }

/// The correction that turns by `turn_rad` about `centre` and then shifts.
Pose2 about(const Point2& centre, double turn_rad, const Point2& shift) {
  const Point2 t = centre + shift - rotate(turn_rad, centre);
  return {t.x(), t.y(), turn_rad};
}

/// Shift of the stand itself under a correction.
Point2 shift_at(const Pose2& correction, const Point2& stand) { return correction * stand - stand; }

std::vector<WallPoint> corrected(const StandPoints& stand, const Pose2& correction) {
  std::vector<WallPoint> points = stand.points;
  for (WallPoint& point : points) {
    point.position = correction * point.position;
    point.per_range = rotate(correction.yaw_rad, point.per_range);
  }
  return points;
}

/// Unknowns: δα, δo_0 … δo_3 of the rectangle, then (δx, δy, δψ) of each stand but the first, about itself.
int first_unknown(std::size_t stand) { return 5 + 3 * (static_cast<int>(stand) - 1); }

/// Normal equations N x = b, and what a range bias of 1 m adds to b.
struct System {
  Matrix normal;
  Vector rhs, per_bias;
  std::array<double, 4> support{};
  double weight = 0.0, squares = 0.0;
};

void add_stand(System& s, const StandPoints& stand, const Pose2& correction, std::size_t index,
               const Rectangle& r, const RectangleFitConfig& config) {
  const Point2 base = correction * stand.T_zone_base.translation();
  const int first = index > 0 ? first_unknown(index) : 5;
  Eigen::Matrix<double, 8, 8> normal = Eigen::Matrix<double, 8, 8>::Zero();
  Eigen::Matrix<double, 8, 1> rhs = Eigen::Matrix<double, 8, 1>::Zero(), per_bias = rhs;
  for (const WallPoint& point : stand.points) {
    const Point2 q = correction * point.position;
    const WallSight sight = sight_of(q, r, config.last_gate_m, config.corner_m);
    if (sight.wall < 0) continue;
    const double w = point.weight * tukey(sight.residual_m, config.last_gate_m);
    const Point2 n = r.normal(sight.wall);
    Eigen::Matrix<double, 8, 1> j = Eigen::Matrix<double, 8, 1>::Zero();
    j[0] = sight.along_m;
    j[1 + sight.wall] = -1.0;
    if (index > 0) j.tail<3>() << n.x(), n.y(), n.dot(left_of(q - base));
    normal += w * j * j.transpose();
    rhs -= w * sight.residual_m * j;
    per_bias -= w * n.dot(rotate(correction.yaw_rad, point.per_range)) * j;
    s.support[static_cast<std::size_t>(sight.wall)] += point.weight;
    s.weight += w;
    s.squares += w * sight.residual_m * sight.residual_m;
  }
  const auto place = [&](auto&& to, const auto& from) { to += from; };
  place(s.normal.topLeftCorner<5, 5>(), normal.topLeftCorner<5, 5>());
  place(s.rhs.head<5>(), rhs.head<5>());
  place(s.per_bias.head<5>(), per_bias.head<5>());
  if (index == 0) return;
  place(s.normal.block<3, 3>(first, first), normal.bottomRightCorner<3, 3>());
  place(s.normal.block<5, 3>(0, first), normal.topRightCorner<5, 3>());
  place(s.normal.block<3, 5>(first, 0), normal.bottomLeftCorner<3, 5>());
  place(s.rhs.segment<3>(first), rhs.tail<3>());
  place(s.per_bias.segment<3>(first), per_bias.tail<3>());
}

/// What odometry says: from stand to stand the corrections change little.
void add_motion(System& s, std::span<const StandPoints> stands, const std::vector<Pose2>& corrections,
                double variance, const JointFitConfig& config) {
  const double shift_weight = variance / (config.motion_sigma_m * config.motion_sigma_m);
  const double turn_weight = variance / std::pow(radians(config.motion_sigma_deg), 2);
  for (std::size_t k = 1; k < stands.size(); ++k) {
    const Point2 here = stands[k].T_zone_base.translation();
    const Point2 way = here - stands[k - 1].T_zone_base.translation();
    const Pose2 &before = corrections[k - 1], &now = corrections[k];
    Eigen::Matrix<double, 3, 6> j;  // of (stand k − 1, stand k)
    j << -1, 0, way.y(), 1, 0, 0,   //
        0, -1, -way.x(), 0, 1, 0,   //
        0, 0, -1, 0, 0, 1;
    Eigen::Vector3d error;
    error << shift_at(now, here) - shift_at(before, here), wrap_to_pi(now.yaw_rad - before.yaw_rad);
    const Eigen::Vector3d w(shift_weight, shift_weight, turn_weight);
    const Eigen::Matrix<double, 6, 6> normal = j.transpose() * w.asDiagonal() * j;
    const Eigen::Matrix<double, 6, 1> rhs = -j.transpose() * w.asDiagonal() * error;
    const int at = first_unknown(k);
    s.normal.block<3, 3>(at, at) += normal.bottomRightCorner<3, 3>();
    s.rhs.segment<3>(at) += rhs.tail<3>();
    if (k == 1) continue;  // the first stand is where it is
    s.normal.block<6, 6>(at - 3, at - 3).topLeftCorner<3, 6>() += normal.topRows<3>();
    s.normal.block<3, 3>(at, at - 3) += normal.bottomLeftCorner<3, 3>();
    s.rhs.segment<3>(at - 3) += rhs.head<3>();
  }
}

}  // namespace

struct JointFitter::Problem {
  Rectangle rectangle;
  std::vector<Pose2> corrections;

  System system(std::span<const StandPoints> stands, const JointFitConfig& config,
                const RectangleFitConfig& fit) const {
    const int unknowns = 5 + 3 * (static_cast<int>(stands.size()) - 1);
    System s{Matrix::Zero(unknowns, unknowns), Vector::Zero(unknowns), Vector::Zero(unknowns)};
    for (std::size_t k = 0; k < stands.size(); ++k)
      add_stand(s, stands[k], corrections[k], k, rectangle, fit);
    const double variance =
        std::max(kLeastSigma_m * kLeastSigma_m, s.weight > 0 ? s.squares / s.weight : 0.0);
    add_motion(s, stands, corrections, variance, config);
    for (int wall = 0; wall < 4; ++wall) {  // not seen: known to a metre
      const bool is_seen = s.support[static_cast<std::size_t>(wall)] >= fit.min_wall_weight;
      s.normal(1 + wall, 1 + wall) += is_seen ? variance : 1e9;
    }
    s.normal(0, 0) += variance;
    return s;
  }

  void step(std::span<const StandPoints> stands, const Vector& x) {
    rectangle = moved(rectangle, x.head<5>());
    for (std::size_t k = 1; k < stands.size(); ++k) {
      const Eigen::Vector3d d = x.segment<3>(first_unknown(k));
      const Point2 base = corrections[k] * stands[k].T_zone_base.translation();
      corrections[k] = about(base, d[2], d.head<2>()) * corrections[k];
    }
  }
};

JointFitter::JointFitter(const JointFitConfig& config, const RectangleFitConfig& fit)
    : config_(config), fit_config_(fit), fitter_(fit) {}

/// Puts the stands on the room one after the other.
void JointFitter::align(std::span<const StandPoints> stands, Problem& problem) const {
  std::vector<WallPoint> pool = stands[0].points;
  for (std::size_t k = 1; k < stands.size(); ++k) {
    Pose2& correction = problem.corrections[k] = problem.corrections[k - 1];
    const auto guessed = corrected(stands[k], correction);
    if (const auto seen = fitter_.fit_pose(guessed, problem.rectangle, config_.reach_m))
      correction = problem.rectangle.pose() * seen->rectangle.pose().inverse() * correction;
    const auto aligned = corrected(stands[k], correction);
    pool.insert(pool.end(), aligned.begin(), aligned.end());
    if (const auto better = fitter_.fit(pool, problem.rectangle, kTogether_m))
      problem.rectangle = better->rectangle;
  }
}

std::optional<JointFit> JointFitter::fit(std::span<const StandPoints> stands, const Rectangle& start,
                                         double reach_m) const {
  if (stands.empty()) return std::nullopt;
  Problem problem{start, std::vector<Pose2>(stands.size())};
  const auto first = fitter_.fit(stands[0].points, start, reach_m);
  if (first) problem.rectangle = first->rectangle;
  if (!first && stands.size() == 1) return std::nullopt;
  align(stands, problem);
  System s;
  for (int i = 0; i < kJointIterations; ++i) {
    s = problem.system(stands, config_, fit_config_);
    problem.step(stands, s.normal.ldlt().solve(s.rhs));
  }
  s = problem.system(stands, config_, fit_config_);
  if (!(s.weight > 0.0)) return std::nullopt;

  JointFit result{{.rectangle = problem.rectangle, .support = s.support}, problem.corrections};
  result.room.rms_m = std::sqrt(s.squares / s.weight);
  const double variance = std::max(kLeastSigma_m * kLeastSigma_m, s.squares / s.weight);
  const auto solver = s.normal.ldlt();
  const Matrix inverse = solver.solve(Matrix::Identity(s.normal.rows(), s.normal.rows()));
  const WallStep per_bias = solver.solve(s.per_bias).head<5>();
  WallMatrix steps = variance * inverse.topLeftCorner<5, 5>();
  for (int wall = 0; wall < 4; ++wall) {
    const bool is_seen = s.support[static_cast<std::size_t>(wall)] >= fit_config_.min_wall_weight;
    steps(1 + wall, 1 + wall) += is_seen ? config_.wall_sigma_m * config_.wall_sigma_m : 1.0;
  }
  const double longest = std::max(problem.rectangle.width_m, problem.rectangle.height_m);
  steps(0, 0) += std::pow(config_.wall_sigma_m / longest, 2);
  steps += config_.range_bias_sigma_m * config_.range_bias_sigma_m * per_bias * per_bias.transpose();
  const WallMatrix m = parameters_by_step(problem.rectangle);
  result.room.per_range_bias = m * per_bias;
  result.room.covariance = m * steps * m.transpose();
  return result;
}

}  // namespace enfilade::room_detector
