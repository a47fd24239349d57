// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/odometry_buffer.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace enfilade::grid_builder {

OdometryBuffer::OdometryBuffer(const OdometryBufferConfig& config) : config_(config) {
  if (config.max_samples < 2) throw std::invalid_argument("max_samples must be at least 2");
  if (config.max_gap_s <= 0.0) throw std::invalid_argument("max_gap_s must be greater than 0");
}

void OdometryBuffer::add(const Odometry& sample) {
  if (reaches(sample.stamp_ns)) return;
  const bool moving = std::abs(sample.linear_m_s) > config_.still_linear_m_s ||
                      std::abs(sample.angular_rad_s) > config_.still_angular_rad_s;
  samples_.push_back({sample.stamp_ns, {to_pose2(sample.T_odom_base), moving}});
  if (samples_.size() > static_cast<std::size_t>(config_.max_samples)) samples_.pop_front();
}

bool OdometryBuffer::is_break(const Odometry& sample) const {
  constexpr double kSpareM = 0.05, kSpareRad = 0.05;
  if (samples_.empty()) return false;
  const Sample& before = samples_.back();
  const double gap_s = seconds(sample.stamp_ns - before.stamp_ns);
  const Pose2 way = before.moment.T_odom_base.inverse() * to_pose2(sample.T_odom_base);
  return gap_s > config_.max_gap_s ||
         way.translation().norm() > kSpareM + gap_s * config_.fastest_linear_m_s ||
         std::abs(wrap_to_pi(way.yaw_rad)) > kSpareRad + gap_s * config_.fastest_angular_rad_s;
}

std::optional<BaseMoment> OdometryBuffer::find_moment(StampNs stamp_ns) const {
  const auto after = std::lower_bound(samples_.begin(), samples_.end(), stamp_ns,
                                      [](const Sample& s, StampNs stamp) { return s.stamp_ns < stamp; });
  if (after == samples_.end()) return std::nullopt;
  if (after->stamp_ns == stamp_ns) return after->moment;
  if (after == samples_.begin()) return std::nullopt;
  const auto before = after - 1;
  const double gap_s = seconds(after->stamp_ns - before->stamp_ns);
  if (gap_s > config_.max_gap_s) return std::nullopt;
  const double t = seconds(stamp_ns - before->stamp_ns) / gap_s;
  return BaseMoment{interpolate(before->moment.T_odom_base, after->moment.T_odom_base, t),
                    before->moment.moving || after->moment.moving};
}

}  // namespace enfilade::grid_builder
