// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/uneven_walls.hpp"

#include <algorithm>

namespace enfilade::room_detector {
namespace {

constexpr double kStretch_m = 0.5;  // about as long as what stands out of a wall or back
constexpr double kTelling = 4.0;    // times the noise: a stretch whose residuals say that it does

/// What the points of one stand on a stretch of a wall add up to, as in WallSums.
struct StretchSum {
  Eigen::Vector2d residuals = Eigen::Vector2d::Zero(), beams = residuals;
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();
  double noise = 0.0;
};

/// What all stands saw of one stretch.
struct Stretch {
  int row = 0;              ///< of the unknown that says how far out its wall is
  Eigen::VectorXd g;        ///< Σ w ρ J
  Eigen::VectorXd by_bias;  ///< what a range bias of 1 m adds to that once all is fitted anew
  double noise = 0.0;       ///< variance of g[row] by the noise of returns

  Stretch(int wall, int unknowns)
      : row(1 + wall), g(Eigen::VectorXd::Zero(unknowns)), by_bias(Eigen::VectorXd::Zero(unknowns)) {}
};

/// The stretches of one wall; one by one for each stand.
std::vector<StretchSum> sums_of(const StandPoints& stand, const Pose2& correction, const Rectangle& r,
                                int wall, const RectangleFitConfig& config) {
  const double length_m = r.wall_length_m(wall);
  std::vector<StretchSum> sums(static_cast<std::size_t>(length_m / kStretch_m) + 1);
  visit_points(stand, correction, r, config, [&](const PointOnWall& point) {
    if (point.wall != wall) return;
    StretchSum& sum = sums[static_cast<std::size_t>((point.along_m + 0.5 * length_m) / kStretch_m)];
    const Eigen::Vector3d powers(1.0, point.along_m, point.along_m * point.along_m);
    sum.residuals += point.w * point.residual_m * powers.head<2>();
    sum.beams += point.w * point.beam * powers.head<2>();
    sum.weights += point.w * powers;
    sum.noise += point.noise;
  });
  return sums;
}

/// Adds what stand `index` saw of a stretch.
void add(Stretch& stretch, const StretchSum& sum, const JacobianLine& j, std::size_t index,
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
  std::vector<Stretch> stretches;
  for (int wall = 0; wall < 4; ++wall) {
    const std::size_t first = stretches.size();
    for (std::size_t k = 0; k < fit.stands.size(); ++k) {
      const auto sums = sums_of(fit.stands[k], fit.corrections[k], fit.rectangle, wall, config);
      const Point2 base = fit.corrections[k] * fit.stands[k].T_zone_base.translation();
      const JacobianLine j = jacobian_of(fit.rectangle, wall, base);
      stretches.resize(first + sums.size(), Stretch(wall, first_unknown(fit.stands.size())));
      for (std::size_t i = 0; i < sums.size(); ++i) {
        add(stretches[first + i], sums[i], j, k, fit.step_per_bias);
        stretches[first + i].noise += fit.variance * sums[i].noise;
      }
    }
  }
  std::erase_if(stretches, [](const Stretch& s) { return !(s.noise > 0.0); });
  return stretches;
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
