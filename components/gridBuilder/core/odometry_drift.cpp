// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/odometry_drift.hpp"

#include <cmath>
#include <stdexcept>

#include <Eigen/LU>

namespace enfilade::grid_builder {
namespace {

constexpr double kPlaceSigma_m = 0.02,
                 kPlaceSigma_rad = 0.01;  // of the place before: what walls tell goes first
constexpr double kWear = 3e-4;            // by which the shares may have changed from place to place
constexpr int kRefusedInARow = 2;         // then it is the estimate that is wrong

Eigen::Matrix3d diagonal_of_squares(double a, double b, double c) {
  return Eigen::Vector3d(a * a, b * b, c * c).asDiagonal();
}

Eigen::Matrix3d unknown_scale(const OdometryDriftConfig& c) {
  return diagonal_of_squares(c.distance_sigma, c.turn_sigma, radians(c.curve_sigma_deg_m));
}

}  // namespace

OdometryDrift::OdometryDrift(const OdometryDriftConfig& config) : config_(config), P_(unknown_scale(config)) {
  if (!(config.distance_sigma >= 0.0 && config.turn_sigma >= 0.0 && config.curve_sigma_deg_m >= 0.0) ||
      !(config.place_sigma_m > 0.0 && config.place_sigma_deg > 0.0 && config.gate_sigma > 0.0))
    throw std::invalid_argument("odometry drift: sigmas must not be negative, those of a place positive");
}

void OdometryDrift::move(const Pose2& T_odom_base) {
  if (!last_ || *last_ == T_odom_base) {
    last_ = T_odom_base;
    return;
  }
  const Pose2 told = last_->inverse() * T_odom_base;
  const Pose2 moved{told.x_m * distance_scale(), told.y_m * distance_scale(),
                    told.yaw_rad * turn_scale() + scale_[2] * told.x_m};
  const Pose2 T_zone_before = T_zone_odom_ * *last_;
  const Point2 step = rotate(T_zone_before.yaw_rad, moved.translation());
  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();  // an error of the heading swings the step
  F(0, 2) = -step.y();
  F(1, 2) = step.x();
  by_scale_ = F * by_scale_;
  by_scale_.block<2, 1>(0, 0) += step;
  by_scale_(2, 1) += told.yaw_rad;
  by_scale_(2, 2) += told.x_m;
  const double way_m = told.translation().norm();
  const double slip_m = config_.slip_m * std::sqrt(way_m);
  const double slip_rad = radians(config_.slip_deg) * std::sqrt(way_m + std::abs(told.yaw_rad));
  by_slip_ = F * by_slip_ * F.transpose() + diagonal_of_squares(slip_m, slip_m, slip_rad);
  T_zone_odom_ = T_zone_before * moved * T_odom_base.inverse();
  last_ = T_odom_base;
}

bool OdometryDrift::settle(const Pose2& T_after_before, const Eigen::Matrix3d& by_walls) {
  const Point2 place = T_zone_base().translation();
  const Point2 shift = T_after_before * place - place;
  const Eigen::Vector3d off(shift.x(), shift.y(), wrap_to_pi(T_after_before.yaw_rad));
  const Eigen::Matrix3d by_odometry = covariance();
  const Eigen::Matrix3d S = by_odometry + by_walls + place_covariance();
  const Eigen::Matrix3d S_inverse = S.inverse();
  if (off.dot(S_inverse * off) > config_.gate_sigma * config_.gate_sigma) {
    if (++refused_ % kRefusedInARow == 0) P_ += 0.25 * unknown_scale(config_);
    return false;
  }
  refused_ = 0;
  const Eigen::Matrix3d K = P_ * by_scale_.transpose() * S_inverse;
  scale_ += K * off;
  P_ = (P_ - K * by_scale_ * P_).eval();
  P_ = (0.5 * (P_ + P_.transpose()) + diagonal_of_squares(kWear, kWear, kWear)).eval();
  const Eigen::Matrix3d loose =
      by_odometry + diagonal_of_squares(kPlaceSigma_m, kPlaceSigma_m, kPlaceSigma_rad);
  take(loose * (loose + by_walls).inverse() * off);
  begin_here();
  return true;
}

/// Moves the robot where it stands.
void OdometryDrift::take(const Eigen::Vector3d& off) {
  const Pose2 T_zone_base = this->T_zone_base();
  const Pose2 there{T_zone_base.x_m + off.x(), T_zone_base.y_m + off.y(),
                    wrap_to_pi(T_zone_base.yaw_rad + off.z())};
  T_zone_odom_ = last_ ? there * last_->inverse() : there;
}

void OdometryDrift::begin_here() {
  by_scale_.setZero();
  by_slip_.setZero();
}

void OdometryDrift::forget_odometry() {
  T_zone_odom_ = T_zone_base();
  last_.reset();
  begin_here();
}

Eigen::Matrix3d OdometryDrift::place_covariance() const {
  // The place before was no better known.
  return 2.0 *
         diagonal_of_squares(config_.place_sigma_m, config_.place_sigma_m, radians(config_.place_sigma_deg));
}

}  // namespace enfilade::grid_builder
