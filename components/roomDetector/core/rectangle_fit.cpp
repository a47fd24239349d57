// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/rectangle_fit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>

#include "components/roomDetector/core/wall_equations.hpp"

namespace enfilade::room_detector {
namespace {

constexpr double kModeBin_m = 0.03;
constexpr double kLeastSupport =
    0.95;  // of what the start has: a result with less has left the wall for something else

/// How far each wall has to move to stand where most points within reach are: the fullest of overlapping
/// pairs of bins.
WallStep step_to_densest(std::span<const WallPoint> points, const Rectangle& r, double reach_m,
                         double corner_m) {
  const int half = std::max(1, static_cast<int>(std::ceil(reach_m / kModeBin_m)));
  std::array<std::vector<double>, 4> histograms;
  histograms.fill(std::vector<double>(static_cast<std::size_t>(2 * half + 2), 0.0));
  const WallSights sights(r, reach_m, corner_m);
  for (const WallPoint& point : points) {
    const WallSight s = sights.of(point.position);
    if (s.wall < 0) continue;
    const int bin = std::clamp(static_cast<int>(std::floor(s.residual_m / kModeBin_m)) + half, 0, 2 * half);
    histograms[static_cast<std::size_t>(s.wall)][static_cast<std::size_t>(bin)] += point.weight;
  }
  WallStep step = WallStep::Zero();
  for (int wall = 0; wall < 4; ++wall) {
    const auto& h = histograms[static_cast<std::size_t>(wall)];
    double fullest = 0.0;
    for (int bin = 0; bin <= 2 * half; ++bin) {
      const double held = h[static_cast<std::size_t>(bin)] + h[static_cast<std::size_t>(bin + 1)];
      if (held <= fullest) continue;
      fullest = held;
      step[1 + wall] = (bin + 1 - half) * kModeBin_m;
    }
  }
  return step;
}

/// The gate narrows from step to step, and faster where the rectangle stands still: it reaches the last gate
/// three iterations before the end, or sooner.
class NarrowingGate {
 public:
  NarrowingGate(const RectangleFitConfig& config, double first_gate_m)
      : last_m_(config.last_gate_m),
        by_step_(std::pow(last_m_ / first_gate_m, 1.0 / std::max(1.0, config.iterations - 3.0))),
        gate_m_(first_gate_m) {}

  double gate_m() const { return gate_m_; }
  bool is_last() const { return gate_m_ <= last_m_; }
  void narrow(double step) {
    constexpr double kStill = 0.02;  // of the gate
    constexpr int kStepsAtOnce = 4;
    const double by = step < kStill * gate_m_ ? std::pow(by_step_, kStepsAtOnce) : by_step_;
    gate_m_ = std::max(last_m_, by * gate_m_);
  }

 private:
  double last_m_, by_step_, gate_m_;
};

/// Keeps unseen walls (and, with none seen, α) where they are.
void hold_unseen(WallEquations& e, double min_wall_weight) {
  constexpr double kHeld = 1e9;
  e.normal(0, 0) += 1e-6;
  for (int wall = 0; wall < 4; ++wall) {
    if (e.support[static_cast<std::size_t>(wall)] < min_wall_weight) e.normal(1 + wall, 1 + wall) += kHeld;
  }
}

template <int Free>
Rectangle iterate(std::span<const WallPoint> points, Rectangle r, const RectangleFitConfig& config,
                  double first_gate_m, const Eigen::Matrix<double, 5, Free>& basis) {
  NarrowingGate gate(config, first_gate_m);
  for (int k = 0; k < config.iterations; ++k) {
    WallEquations e = wall_equations(points, r, gate.gate_m(), config.corner_m);
    hold_unseen(e, Free == 5 ? config.min_wall_weight : 0.0);
    const Eigen::Matrix<double, Free, Free> normal = basis.transpose() * e.normal * basis;
    const Eigen::Matrix<double, Free, 1> right = basis.transpose() * e.rhs;
    const Eigen::Matrix<double, Free, 1> step = normal.ldlt().solve(right);
    r = moved(r, basis * step);
    if (gate.is_last() && step.norm() < kSettled) break;
    gate.narrow(step.norm());
  }
  return r;
}

RectangleFit result_at(std::span<const WallPoint> points, const Rectangle& r,
                       const RectangleFitConfig& config) {
  WallEquations e = wall_equations(points, r, config.last_gate_m, config.corner_m);
  RectangleFit fit{.rectangle = r, .support = e.support};
  const double variance = e.weight > 0.0 ? e.squares / e.weight : 0.0;
  fit.rms_m = std::sqrt(variance);
  // A wall that is not seen is known to the reach of the Hough cell at best: 1 m² stands for "not at all".
  for (int wall = 0; wall < 4; ++wall) e.normal(1 + wall, 1 + wall) += variance;
  e.normal(0, 0) += variance;
  const WallMatrix m = parameters_by_step(r);
  const WallMatrix inverse = e.normal.ldlt().solve(WallMatrix::Identity());
  fit.covariance = m * (variance * inverse) * m.transpose();
  return fit;
}

/// The points that can come to lie near a wall: all others need not be looked at in every iteration.
std::vector<WallPoint> points_near(std::span<const WallPoint> points, const Rectangle& r, double distance_m) {
  std::vector<WallPoint> near;
  const WallSights sights(r, distance_m, -distance_m);
  for (const WallPoint& point : points)
    if (sights.of(point.position).wall >= 0) near.push_back(point);
  return near;
}

/// A wide gate to begin with where the walls were only known coarsely.
double first_gate(const RectangleFitConfig& config, double reach_m) {
  return std::max(config.first_gate_m, 0.5 * reach_m);
}

}  // namespace

RectangleFitter::RectangleFitter(const RectangleFitConfig& config) : config_(config) {}

std::optional<RectangleFit> RectangleFitter::fit(std::span<const WallPoint> all_points,
                                                 const Rectangle& start, double reach_m) const {
  const auto points = points_near(all_points, start, 2.0 * (reach_m + config_.first_gate_m));
  const auto fit_from = [&](const Rectangle& from) {
    const WallMatrix free = WallMatrix::Identity();
    return result_at(points, iterate<5>(points, from, config_, first_gate(config_, reach_m), free), config_);
  };
  RectangleFit best = fit_from(start);
  const WallStep to_densest = step_to_densest(points, start, reach_m, config_.corner_m);
  if (!to_densest.isZero()) {
    const RectangleFit from_densest = fit_from(moved(start, to_densest));
    if (from_densest.total_support() >= best.total_support()) best = from_densest;
  }
  if (best.total_support() < kLeastSupport * result_at(points, start, config_).total_support())
    return std::nullopt;
  if (best.rectangle.width_m <= 0.0 || best.rectangle.height_m <= 0.0) return std::nullopt;
  return best;
}

std::optional<RectangleFit> RectangleFitter::fit_pose(std::span<const WallPoint> points,
                                                      const Rectangle& start, double reach_m) const {
  Eigen::Matrix<double, 5, 3> rigid;  // a shift along x moves wall 0 out and wall 2 in; along y walls 1 and 3
  rigid << 1, 0, 0,                   //
      0, 1, 0,                        //
      0, 0, 1,                        //
      0, -1, 0,                       //
      0, 0, -1;
  const auto fit =
      result_at(points, iterate<3>(points, start, config_, first_gate(config_, reach_m), rigid), config_);
  const bool sees_x = std::max(fit.support[0], fit.support[2]) >= config_.min_wall_weight;
  const bool sees_y = std::max(fit.support[1], fit.support[3]) >= config_.min_wall_weight;
  return sees_x && sees_y ? std::optional(fit) : std::nullopt;
}

}  // namespace enfilade::room_detector
