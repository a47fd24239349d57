// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/joint_fit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "components/roomDetector/core/wall_equations.hpp"

namespace enfilade::room_detector {
namespace {

constexpr int kJointIterations = 6, kBiasIterations = 4;
constexpr double kNearWalls_m = 0.15;  // what a bias could bring to a wall, or take from it
constexpr double kTogether_m = 0.06;   // walls of aligned stands lie so near

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
  const PointMover move(correction);
  for (WallPoint& point : points) {
    point.position = move(point.position);
    point.per_range = move.turned(point.per_range);
  }
  return points;
}

/// Unknowns: δα, δo_0 … δo_3 of the rectangle, then (δx, δy, δψ) of each stand but the first, about itself.
int first_unknown(std::size_t stand) { return 5 + 3 * (static_cast<int>(stand) - 1); }

/// Normal equations N x = b, what a range bias of 1 m adds to b, and the covariance of b in units of that of
/// one return.
struct System {
  Matrix normal;
  Vector rhs, per_bias;
  Matrix noise;
  std::array<double, 4> support{};
  double weight = 0.0, squares = 0.0;  ///< Σ w and Σ w ρ² of the residuals
  double variance = 0.0;               ///< of one return

  explicit System(int unknowns)
      : normal(Matrix::Zero(unknowns, unknowns)),
        rhs(Vector::Zero(unknowns)),
        per_bias(Vector::Zero(unknowns)),
        noise(Matrix::Zero(unknowns, unknowns)) {}
};

/// What the points of one stand on one wall add up to. Σ x stands for (Σ x, Σ x t, Σ x t²), t along the wall:
/// all that is needed of them, as the row of a point's Jacobian is a line in t.
struct WallSums {
  Eigen::Vector3d weights = Eigen::Vector3d::Zero(), noises = weights;     ///< Σ w, Σ w² σ² / weight
  Eigen::Vector2d residuals = Eigen::Vector2d::Zero(), beams = residuals;  ///< Σ w ρ, Σ w ∂ρ/∂range
  double support = 0.0, squares = 0.0;                                     ///< Σ weight, Σ w ρ²
};

std::array<WallSums, 4> wall_sums(const StandPoints& stand, const Pose2& correction, const Rectangle& r,
                                  const RectangleFitConfig& config) {
  std::array<WallSums, 4> sums;
  const PointMover move(correction);
  const WallSights sights(r, config.last_gate_m, config.corner_m);
  const std::array<Point2, 4> normals{r.normal(0), r.normal(1), r.normal(2), r.normal(3)};
  for (const WallPoint& point : stand.points) {
    const WallSight sight = sights.of(move(point.position));
    if (sight.wall < 0) continue;
    WallSums& sum = sums[static_cast<std::size_t>(sight.wall)];
    const double share = tukey(sight.residual_m, config.last_gate_m), w = point.weight * share;
    const double beam = normals[static_cast<std::size_t>(sight.wall)].dot(move.turned(point.per_range));
    const double slant = point.per_range.isZero() ? 1.0 : beam * beam;
    const Eigen::Vector3d powers(1.0, sight.along_m, sight.along_m * sight.along_m);
    sum.weights += w * powers;
    sum.noises += w * share * slant * powers;
    sum.residuals += w * sight.residual_m * powers.head<2>();
    sum.beams += w * beam * powers.head<2>();
    sum.support += point.weight;
    sum.squares += w * sight.residual_m * sight.residual_m;
  }
  return sums;
}

/// The row of the Jacobian of a point `t` along a wall, over (δα, δo_wall, δx, δy, δψ), is at_centre + t ·
/// per_metre.
struct JacobianLine {
  Eigen::Matrix<double, 5, 1> at_centre, per_metre;

  /// Σ x j, of (Σ x, Σ x t).
  Eigen::Matrix<double, 5, 1> sum(const Eigen::Vector2d& x) const {
    return x[0] * at_centre + x[1] * per_metre;
  }
  /// Σ x j jᵀ, of (Σ x, Σ x t, Σ x t²).
  Eigen::Matrix<double, 5, 5> squares(const Eigen::Vector3d& x) const {
    const Eigen::Matrix<double, 5, 5> mixed = at_centre * per_metre.transpose();
    return x[0] * at_centre * at_centre.transpose() + x[1] * (mixed + mixed.transpose()) +
           x[2] * per_metre * per_metre.transpose();
  }
};

/// With t = left(n) a turn of the stand about `base` moves a point q along n by n · left(q − base) =
/// −t · (q − base).
JacobianLine jacobian_of(const Rectangle& r, int wall, const Point2& base) {
  const Point2 n = r.normal(wall), t = left_of(n);
  JacobianLine line;
  line.at_centre << 0.0, -1.0, n, t.dot(base - Point2(r.x_m, r.y_m));
  line.per_metre << 1.0, 0.0, 0.0, 0.0, -1.0;
  return line;
}

void add_stand(System& s, const StandPoints& stand, const Pose2& correction, std::size_t index,
               const Rectangle& r, const RectangleFitConfig& config) {
  const Point2 base = correction * stand.T_zone_base.translation();
  const auto sums = wall_sums(stand, correction, r, config);
  const int entries = index > 0 ? 5 : 2, first = index > 0 ? first_unknown(index) : 0;
  for (int wall = 0; wall < 4; ++wall) {
    const WallSums& sum = sums[static_cast<std::size_t>(wall)];
    const std::array<int, 5> at{0, 1 + wall, first, first + 1, first + 2};
    const JacobianLine j = jacobian_of(r, wall, base);
    const auto normal = j.squares(sum.weights), noise = j.squares(sum.noises);
    const auto residuals = j.sum(sum.residuals), beams = j.sum(sum.beams);
    for (int a = 0; a < entries; ++a) {
      const int row = at[static_cast<std::size_t>(a)];
      for (int b = 0; b < entries; ++b) {
        s.normal(row, at[static_cast<std::size_t>(b)]) += normal(a, b);
        s.noise(row, at[static_cast<std::size_t>(b)]) += noise(a, b);
      }
      s.rhs[row] -= residuals[a];
      s.per_bias[row] -= beams[a];
    }
    s.support[static_cast<std::size_t>(wall)] += sum.support;
    s.weight += sum.weights[0];
    s.squares += sum.squares;
  }
}

/// What odometry says: from stand to stand the corrections change little.
void add_motion(System& s, std::span<const StandPoints> stands, const std::vector<Pose2>& corrections,
                const JointFitConfig& config) {
  const double shift_weight = s.variance / (config.motion_sigma_m * config.motion_sigma_m);
  const double turn_weight = s.variance / std::pow(radians(config.motion_sigma_deg), 2);
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

  System system(std::span<const StandPoints> stands, const JointFitConfig& config,
                const RectangleFitConfig& fit) const {
    System s(5 + 3 * (static_cast<int>(stands.size()) - 1));
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
      const System s = system(stands, config, fit);
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
  const System s = problem.system(stands, config_, fit_config_);
  if (!(s.weight > 0.0)) return std::nullopt;

  JointFit result{{.rectangle = problem.rectangle, .support = s.support}, problem.corrections};
  result.room.rms_m = std::sqrt(s.squares / s.weight);
  const auto solver = s.normal.ldlt();
  const Matrix inverse = solver.solve(Matrix::Identity(s.normal.rows(), s.normal.rows()));
  const WallStep per_bias = solver.solve(s.per_bias).head<5>();
  WallMatrix steps = s.variance * (inverse * s.noise * inverse).topLeftCorner<5, 5>();
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
