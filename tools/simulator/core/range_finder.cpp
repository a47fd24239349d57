// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/core/range_finder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace enfilade::simulator {
namespace {

constexpr float kNoEcho = std::numeric_limits<float>::infinity();
constexpr double kNoiseStep_m = 10.0;
constexpr double kFirstBeam_rad = -0.75 * kPi;
constexpr double kBeamStep_rad = 2.0 * kPi / RangeFinder::kBeamsPerTurn;
constexpr double kBeamTime_ns = static_cast<double>(RangeFinder::kLine_ns) / RangeFinder::kBeamsPerTurn;

}  // namespace

RangeFinder::RangeFinder(const RangeFinderConfig& config, const BodyConfig& body)
    : config_(config), body_(body), true_m_(kBeams, kNoEcho) {
  if (config.range_max_m <= config.range_min_m || config.sigma_near_m < 0 || config.sigma_far_m < 0)
    throw std::invalid_argument("RangeFinderConfig: ranges must grow and sigmas must not be negative");
  for (int i = 0; i < kBeams; ++i) {
    cos_.push_back(std::cos(kFirstBeam_rad + i * kBeamStep_rad));
    sin_.push_back(std::sin(kFirstBeam_rad + i * kBeamStep_rad));
  }
}

Ray RangeFinder::beam(int index, const Pose2& T_world_base, double roll_rad) const {
  const Point2 origin = T_world_base * Point2(config_.mount_x_m, config_.mount_y_m);
  const Point2 flat = rotate(T_world_base.yaw_rad, {cos_[index], sin_[index] * std::cos(roll_rad)});
  return {static_cast<float>(origin.x()),        static_cast<float>(origin.y()),
          static_cast<float>(config_.mount_z_m), static_cast<float>(flat.x()),
          static_cast<float>(flat.y()),          static_cast<float>(sin_[index] * std::sin(roll_rad))};
}

double RangeFinder::own_body_m(int index, double roll_rad) const {
  const Point2 o(config_.mount_x_m, config_.mount_y_m);
  const Point2 d(cos_[index], sin_[index] * std::cos(roll_rad));
  const double dz = sin_[index] * std::sin(roll_rad), above_m = config_.mount_z_m - body_.height_m;
  if (dz < 0.0 && above_m >= 0.0) {  // the lid
    const double t = -above_m / dz;
    if ((o + t * d).norm() <= body_.radius_m) return t;
  }
  const double a = d.squaredNorm(), b = o.dot(d), c = o.squaredNorm() - body_.radius_m * body_.radius_m;
  if (c <= 0.0 || b >= 0.0 || b * b < a * c) return kNoEcho;  // over the lid, or the mantle is missed
  const double t = (-b - std::sqrt(b * b - a * c)) / a;
  const double z_m = config_.mount_z_m + t * dz;
  return z_m >= 0.0 && z_m <= body_.height_m ? t : kNoEcho;
}

std::optional<LaserScan> RangeFinder::sense(const SensorState& from, const SensorState& to,
                                            const RayScene& scene, Random& random) {
  rays_.clear();
  const int first = next_beam_;
  const double step_ns = static_cast<double>(to.stamp_ns - from.stamp_ns);
  std::array<float, kBeams> own_m;
  for (; next_beam_ < kBeams; ++next_beam_) {
    const double after_ns = static_cast<double>(line_start_ns_ - from.stamp_ns) + next_beam_ * kBeamTime_ns;
    if (after_ns >= step_ns) break;
    const double share = after_ns / step_ns;
    const double roll_rad = from.roll_rad + share * (to.roll_rad - from.roll_rad);
    rays_.push_back(beam(next_beam_, interpolate(from.T_world_base, to.T_world_base, share), roll_rad));
    own_m[next_beam_] = static_cast<float>(own_body_m(next_beam_, roll_rad));
  }
  scene.cast(rays_, std::span(true_m_).subspan(first, rays_.size()));
  for (int i = first; i < next_beam_; ++i) true_m_[i] = std::min(true_m_[i], own_m[i]);

  std::optional<LaserScan> line;
  if (first < kBeams && next_beam_ == kBeams) line = finish(random);
  if (to.stamp_ns >= line_start_ns_ + kLine_ns) {
    line_start_ns_ += kLine_ns;
    next_beam_ = 0;
  }
  return line;
}

double RangeFinder::mixed(int index, Random& random) const {
  const double here_m = true_m_[index];
  for (const int neighbour : {index - 1, index + 1}) {
    if (neighbour < 0 || neighbour >= kBeams) continue;
    const double jump_m = true_m_[neighbour] - here_m;
    if (jump_m < config_.mixed_pixel_min_jump_m || jump_m > config_.mixed_pixel_max_jump_m) continue;
    return random.happens(config_.mixed_pixel_probability) ? here_m + random.uniform() * jump_m : here_m;
  }
  return here_m;
}

float RangeFinder::measured(int index, Random& random) const {
  if (!std::isfinite(true_m_[index]) || random.happens(config_.dropout_probability)) return kNoEcho;
  const double range_m = mixed(index, random) + config_.bias_m;
  const double noisy_m =
      range_m + random.gauss(range_m <= kNoiseStep_m ? config_.sigma_near_m : config_.sigma_far_m);
  if (noisy_m > config_.range_max_m) return kNoEcho;
  if (noisy_m < config_.range_min_m) return -kNoEcho;
  return static_cast<float>(noisy_m);
}

LaserScan RangeFinder::finish(Random& random) const {
  LaserScan scan;
  scan.stamp_ns = line_start_ns_;
  scan.frame_id = "laser_scan";
  scan.angle_min_rad = static_cast<float>(kFirstBeam_rad);
  scan.angle_max_rad = static_cast<float>(-kFirstBeam_rad);
  scan.angle_increment_rad = static_cast<float>(kBeamStep_rad);
  scan.time_increment_s = static_cast<float>(1e-9 * kBeamTime_ns);
  scan.scan_time_s = static_cast<float>(seconds(kLine_ns));
  scan.range_min_m = static_cast<float>(config_.range_min_m);
  scan.range_max_m = static_cast<float>(config_.range_max_m);
  scan.ranges_m.reserve(kBeams);
  for (int i = 0; i < kBeams; ++i) scan.ranges_m.push_back(measured(i, random));
  return scan;
}

}  // namespace enfilade::simulator
