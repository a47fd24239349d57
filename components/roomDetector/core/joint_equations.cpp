// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/joint_equations.hpp"

#include <cmath>

#include "components/roomDetector/core/points_on_walls.hpp"

namespace enfilade::room_detector {
namespace {

/// Shift of the stand itself under a correction.
Point2 shift_at(const Pose2& correction, const Point2& stand) { return correction * stand - stand; }

std::array<WallSums, 4> wall_sums(const StandPoints& stand, const Pose2& correction, const Rectangle& r,
                                  const RectangleFitConfig& config) {
  std::array<WallSums, 4> sums;
  visit_points(stand, correction, r, config,
               [&](const PointOnWall& point) { sums[static_cast<std::size_t>(point.wall)].add(point); });
  return sums;
}

}  // namespace

void add_stand(JointSystem& s, const StandPoints& stand, const Pose2& correction, std::size_t index,
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

void add_motion(JointSystem& s, std::span<const StandPoints> stands, const std::vector<Pose2>& corrections,
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

}  // namespace enfilade::room_detector
