// SPDX-License-Identifier: Apache-2.0
#include "components/motorControl/core/wheel_odometry.hpp"

#include <cmath>
#include <stdexcept>

namespace enfilade::motor_control {

WheelOdometry::WheelOdometry(const WheelOdometryConfig& config, const DifferentialDrive& drive)
    : config_(config), drive_(drive) {
  if (!(config.speed_window_s >= 0.005) || !(config.settle_s >= 0.0))
    throw std::invalid_argument("odometry: speed_window_s must be at least 0.005 and settle_s not negative");
}

void WheelOdometry::update(StampNs stamp_ns, const Wheels& angles_rad) {
  if (!window_.empty()) {
    const Wheels& before = window_.back().angles_rad;
    T_odom_base_ =
        T_odom_base_ * drive_.arc({angles_rad.left - before.left, angles_rad.right - before.right});
  }
  window_.push_back({stamp_ns, angles_rad});
  while (window_.size() > 2 && seconds(stamp_ns - window_[1].stamp_ns) >= config_.speed_window_s)
    window_.pop_front();
  measure_speed();
}

void WheelOdometry::measure_speed() {
  const Sample &first = window_.front(), &last = window_.back();
  if (last.stamp_ns <= first.stamp_ns) return;
  const double span_s = seconds(last.stamp_ns - first.stamp_ns);
  speed_ = drive_.base_speed({(last.angles_rad.left - first.angles_rad.left) / span_s,
                              (last.angles_rad.right - first.angles_rad.right) / span_s});
  if (std::abs(speed_.linear_m_s) > config_.still_linear_m_s ||
      std::abs(speed_.angular_rad_s) > config_.still_angular_rad_s) {
    last_moved_ns_ = last.stamp_ns;
    moving_ = true;
  } else if (seconds(last.stamp_ns - last_moved_ns_) >= config_.settle_s) {
    moving_ = false;
  }
}

}  // namespace enfilade::motor_control
