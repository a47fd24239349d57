// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/joint_fit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "components/roomDetector/core/uneven_walls.hpp"

namespace enfilade::room_detector {
namespace {

constexpr int kJointIterations = 6, kBiasIterations = 4;
constexpr double kNearWalls_m = 0.15;  // what a bias could bring to a wall, or take from it
constexpr double kTogether_m = 0.06;   // walls of aligned stands lie so near

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

/// The correction that turns by `turn_rad` about `centre` and then shifts.
Pose2 about(const Point2& centre, double turn_rad, const Point2& shift) {
  const Point2 t = centre + shift - rotate(turn_rad, centre);
  return {t.x(), t.y(), turn_rad};
}

std::vector<WallPoint> corrected(const StandPoints& stand, const Pose2& correction) {
  std::vector<WallPoint> points = stand.points;
  const PointMover move(correction);
  for (WallPoint& point : points) {
    point.position = move(point.position);
    point.per_range = move.turned(point.per_range);
  }
  return points;
}

/// The points near the walls, with what a laser adds that measures `bias_m` too much taken off again.
std::vector<StandPoints> without_bias(std::span<const StandPoints> stands,
                                      const std::vector<Pose2>& corrections, const Rectangle& r,
                                      double bias_m) {
  std::vector<StandPoints> out;
  const WallSights near(r, kNearWalls_m, 0.0);
  for (std::size_t k = 0; k < stands.size(); ++k) {
    StandPoints& stand = out.emplace_back(stands[k].T_zone_base, std::vector<WallPoint>{});
    const PointMover move(corrections[k]);
    for (WallPoint point : stands[k].points) {
      if (near.of(move(point.position)).wall < 0) continue;
      point.position -= bias_m * point.per_range;
      stand.points.push_back(point);
    }
  }
  return out;
}

/// The step that moves `a` to `b`, which is almost the same.
WallStep step_between(const Rectangle& a, const Rectangle& b) {
  WallStep step;
  step[0] = wrap_to_pi(b.yaw_rad - a.yaw_rad);
  for (int wall = 0; wall < 4; ++wall) {
    const double shift = Point2(b.x_m - a.x_m, b.y_m - a.y_m).dot(b.normal(wall));
    step[1 + wall] = shift + 0.5 * (b.wall_length_m(wall + 1) - a.wall_length_m(wall + 1));
  }
  return step;
}

}  // namespace

struct JointFitter::Problem {
  Rectangle rectangle;
  std::vector<Pose2> corrections;

  JointSystem system(std::span<const StandPoints> stands, const JointFitConfig& config,
                     const RectangleFitConfig& fit) const {
    JointSystem s(5 + 3 * (static_cast<int>(stands.size()) - 1));
    for (std::size_t k = 0; k < stands.size(); ++k)
      add_stand(s, stands[k], corrections[k], k, rectangle, fit);
    // The points are means of returns: what they scatter by is the least that a single one may.
    s.variance =
        std::max(config.range_sigma_m * config.range_sigma_m, s.weight > 0 ? s.squares / s.weight : 0.0);
    const Matrix of_returns = s.normal;
    add_motion(s, stands, corrections, config);
    for (int wall = 0; wall < 4; ++wall) {  // not seen: known to a metre
      const bool is_seen = s.support[static_cast<std::size_t>(wall)] >= fit.min_wall_weight;
      s.normal(1 + wall, 1 + wall) += is_seen ? s.variance : 1e9;
    }
    s.normal(0, 0) += s.variance;
    s.noise += s.normal - of_returns;
    return s;
  }

  void solve(std::span<const StandPoints> stands, const JointFitConfig& config, const RectangleFitConfig& fit,
             int iterations) {
    for (int i = 0; i < iterations; ++i) {
      const JointSystem s = system(stands, config, fit);
      const Vector x = s.normal.ldlt().solve(s.rhs);
      step(stands, x);
      if (x.norm() < kSettled) break;
    }
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
  problem.solve(stands, config_, fit_config_, kJointIterations);
  const JointSystem s = problem.system(stands, config_, fit_config_);
  if (!(s.weight > 0.0)) return std::nullopt;

  JointFit result{{.rectangle = problem.rectangle, .support = s.support}, problem.corrections};
  result.room.rms_m = std::sqrt(s.squares / s.weight);
  const auto solver = s.normal.ldlt();
  const Matrix inverse = solver.solve(Matrix::Identity(s.normal.rows(), s.normal.rows()));
  const Vector step_per_bias = solver.solve(s.per_bias);
  const Matrix noise =
      s.variance * s.noise +
      unevenness({stands, problem.corrections, problem.rectangle, s.variance, step_per_bias}, fit_config_);
  const WallStep per_bias = step_per_bias.head<5>();
  WallMatrix steps = (inverse * noise * inverse).topLeftCorner<5, 5>();
  for (int wall = 0; wall < 4; ++wall) {
    const bool is_seen = s.support[static_cast<std::size_t>(wall)] >= fit_config_.min_wall_weight;
    steps(1 + wall, 1 + wall) += is_seen ? config_.wall_sigma_m * config_.wall_sigma_m : 1.0;
  }
  const double longest = std::max(problem.rectangle.width_m, problem.rectangle.height_m);
  steps(0, 0) += std::pow(config_.wall_sigma_m / longest, 2);
  if (config_.range_bias_sigma_m > 0.0) steps += spread_by_bias(stands, problem, per_bias);
  const WallMatrix m = parameters_by_step(problem.rectangle);
  result.room.per_range_bias = m * per_bias;
  result.room.covariance = m * steps * m.transpose();
  return result;
}

/// With the bias b spread evenly over ±a, the step e it makes is g b while it is small; far from zero, walls
/// seen at a slant bend by it so that the robust weights change. e(±a) is found by taking the bias off the
/// points and solving again: e(t a) = G t + H t² + K t³ with G = g a, and E[e eᵀ] follows from those of t²,
/// t⁴, t⁶.
WallMatrix JointFitter::spread_by_bias(std::span<const StandPoints> stands, const Problem& problem,
                                       const WallStep& per_bias) const {
  const double most_m = std::sqrt(3.0) * config_.range_bias_sigma_m;
  const auto step_at = [&](double bias_m) -> WallStep {
    const auto points = without_bias(stands, problem.corrections, problem.rectangle, bias_m);
    Problem unbiased = problem;
    unbiased.rectangle = moved(problem.rectangle, -bias_m * per_bias);
    unbiased.solve(points, config_, fit_config_, kBiasIterations);
    return -step_between(problem.rectangle, unbiased.rectangle);
  };
  const WallStep longer = step_at(most_m), shorter = step_at(-most_m), G = most_m * per_bias;
  const WallStep H = 0.5 * (longer + shorter), K = 0.5 * (longer - shorter) - G;
  return G * G.transpose() / 3.0 + (H * H.transpose() + G * K.transpose() + K * G.transpose()) / 5.0 +
         K * K.transpose() / 7.0;
}

}  // namespace enfilade::room_detector
