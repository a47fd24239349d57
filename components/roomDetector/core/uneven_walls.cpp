// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/uneven_walls.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace enfilade::room_detector {
namespace {

constexpr double kStretch_m = 0.5;  // about as long as what stands out of a wall or back
constexpr double kTelling = 4.0;    // times the noise: a stretch whose residuals say that it does

/// What all stands saw of one stretch.
struct Stretch {
  int row = 0;              ///< of the unknown that says how far out its wall is
  Eigen::VectorXd g;        ///< Σ w ρ J
  Eigen::VectorXd by_bias;  ///< what a range bias of 1 m adds to that once all is fitted anew
  double noise = 0.0;       ///< variance of g[row] by the noise of returns

  Stretch(int wall, int unknowns)
      : row(1 + wall), g(Eigen::VectorXd::Zero(unknowns)), by_bias(Eigen::VectorXd::Zero(unknowns)) {}
};

using StretchSums = std::array<std::vector<WallSums>, 4>;

/// What one stand saw of the stretches of each wall.
StretchSums sums_of(const StandPoints& stand, const Pose2& correction, const Rectangle& r,
                    const RectangleFitConfig& config) {
  StretchSums sums;
  for (std::size_t wall = 0; wall < 4; ++wall)
    sums[wall].resize(static_cast<std::size_t>(r.wall_length_m(static_cast<int>(wall)) / kStretch_m) + 1);
  visit_points(stand, correction, r, config, [&](const PointOnWall& point) {
    const double from_corner_m = point.along_m + 0.5 * r.wall_length_m(point.wall);
    sums[static_cast<std::size_t>(point.wall)][static_cast<std::size_t>(from_corner_m / kStretch_m)].add(
        point);
  });
  return sums;
}

/// Adds what stand `index` saw of a stretch.
void add(Stretch& stretch, const WallSums& sum, const JacobianLine& j, std::size_t index,
         const Eigen::VectorXd& step_per_bias) {
  const int first = first_unknown(index);
  Eigen::Matrix<double, 5, 1> step = Eigen::Matrix<double, 5, 1>::Zero();
  step.head<2>() << step_per_bias[0], step_per_bias[stretch.row];
  if (index > 0) step.tail<3>() = step_per_bias.segment<3>(first);
  const auto place = [&](Eigen::VectorXd& to, const Eigen::Matrix<double, 5, 1>& from) {
    to[0] += from[0];
    to[stretch.row] += from[1];
    if (index > 0) to.segment<3>(first) += from.tail<3>();
  };
  place(stretch.g, j.sum(sum.residuals));
  place(stretch.by_bias, j.sum(sum.beams) + j.squares(sum.weights) * step);
}

std::vector<Stretch> stretches_of(const FittedStands& fit, const RectangleFitConfig& config) {
  const int unknowns = first_unknown(fit.stands.size());
  std::array<std::vector<Stretch>, 4> by_wall;
  for (std::size_t k = 0; k < fit.stands.size(); ++k) {
    const StretchSums sums = sums_of(fit.stands[k], fit.corrections[k], fit.rectangle, config);
    const Point2 base = fit.corrections[k] * fit.stands[k].T_zone_base.translation();
    for (std::size_t wall = 0; wall < 4; ++wall) {
      const JacobianLine j = jacobian_of(fit.rectangle, static_cast<int>(wall), base);
      by_wall[wall].resize(sums[wall].size(), Stretch(static_cast<int>(wall), unknowns));
      for (std::size_t i = 0; i < sums[wall].size(); ++i) {
        add(by_wall[wall][i], sums[wall][i], j, k, fit.step_per_bias);
        by_wall[wall][i].noise += fit.variance * sums[wall][i].noises[0];
      }
    }
  }
  std::vector<Stretch> seen;
  for (const std::vector<Stretch>& wall : by_wall)
    std::copy_if(wall.begin(), wall.end(), std::back_inserter(seen),
                 [](const Stretch& s) { return s.noise > 0.0; });
  return seen;
}

/// The range bias that explains the residuals best.
double bias_m(const std::vector<Stretch>& stretches) {
  double product = 0.0, square = 0.0;
  for (const Stretch& s : stretches) {
    product += s.g[s.row] * s.by_bias[s.row] / s.noise;
    square += s.by_bias[s.row] * s.by_bias[s.row] / s.noise;
  }
  return square > 0.0 ? product / square : 0.0;
}

}  // namespace

Eigen::MatrixXd unevenness(const FittedStands& fit, const RectangleFitConfig& config) {
  const std::vector<Stretch> stretches = stretches_of(fit, config);
  const double bias = bias_m(stretches);
  const int unknowns = first_unknown(fit.stands.size());
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(unknowns, unknowns);
  for (const Stretch& s : stretches) {
    const Eigen::VectorXd g = s.g - bias * s.by_bias;
    const double square = g[s.row] * g[s.row];
    if (square > kTelling * s.noise) covariance += (1.0 - s.noise / square) * g * g.transpose();
  }
  return covariance;
}

}  // namespace enfilade::room_detector
