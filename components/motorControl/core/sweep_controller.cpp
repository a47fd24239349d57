// SPDX-License-Identifier: Apache-2.0
#include "components/motorControl/core/sweep_controller.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace enfilade::motor_control {
namespace {

constexpr double kShortestStroke_rad = 0.01;
constexpr double kSlowestStroke_rad_s = 0.005;

bool is_usable(const SweepCommand& c) {
  if (!std::isfinite(c.from_rad)) return false;
  return c.action == SweepAction::kPark ||
         (std::isfinite(c.to_rad) && std::isfinite(c.speed_rad_s) && c.speed_rad_s > 0.0);
}

/// The moment at which a straight line between two readings passes `level_rad`.
StampNs crossing_ns(StampNs from_ns, double from_rad, StampNs to_ns, double to_rad, double level_rad) {
  if (to_rad == from_rad) return to_ns;
  const double share = std::clamp((level_rad - from_rad) / (to_rad - from_rad), 0.0, 1.0);
  return from_ns + static_cast<StampNs>(share * static_cast<double>(to_ns - from_ns));
}

}  // namespace

SweepController::SweepController(const SweepControllerConfig& config) : config_(config) {
  if (!(config.lowest_rad < config.highest_rad))
    throw std::invalid_argument("sweep: lowest_rad must be below highest_rad");
  const double lowest = std::min({config.overrun_rad, config.max_speed_rad_s, config.acceleration_rad_s2,
                                  config.settle_s, config.tolerance_rad});
  if (!(lowest > 0.0)) throw std::invalid_argument("sweep: every limit must be greater than 0");
  if (!(max_stroke_speed_rad_s() > kSlowestStroke_rad_s))
    throw std::invalid_argument("sweep: overrun_rad leaves no room to reach any speed; raise it");
}

double SweepController::max_stroke_speed_rad_s() const {
  // The greatest v with v² / 2a + v · settle + 2 · tolerance <= overrun.
  const double a = config_.acceleration_rad_s2, room_rad = config_.overrun_rad - 2.0 * config_.tolerance_rad;
  if (room_rad <= 0.0) return 0.0;
  const double v =
      a * (std::sqrt(config_.settle_s * config_.settle_s + 2.0 * room_rad / a) - config_.settle_s);
  return std::min(v, config_.max_speed_rad_s);
}

double SweepController::run_up_rad() const {
  const double v = stroke_.speed_rad_s;
  return v * v / (2.0 * config_.acceleration_rad_s2) + v * config_.settle_s + config_.tolerance_rad;
}

SweepVerdict SweepController::command(const SweepCommand& c) {
  if (c.sweep_id <= sweep_id_) return SweepVerdict::kKnown;
  if (!is_usable(c)) return SweepVerdict::kInvalid;
  const double from_rad = std::clamp(c.from_rad, config_.lowest_rad, config_.highest_rad);
  if (c.action == SweepAction::kPark) {
    park_rad_ = from_rad;
  } else {
    const double to_rad = std::clamp(c.to_rad, config_.lowest_rad, config_.highest_rad);
    if (std::abs(to_rad - from_rad) < kShortestStroke_rad) return SweepVerdict::kInvalid;
    park_rad_.reset();
    stroke_ = {.low_rad = std::min(from_rad, to_rad), .high_rad = std::max(from_rad, to_rad)};
    stroke_.speed_rad_s = std::clamp(c.speed_rad_s, kSlowestStroke_rad_s, max_stroke_speed_rad_s());
  }
  sweep_id_ = c.sweep_id;
  begin_approach();
  return SweepVerdict::kAccepted;
}

void SweepController::begin_approach() {
  phase_ = SweepPhase::kApproaching;
  running_up_ = false;
  stroke_.direction = 0.0;
  start_ns_ = end_ns_ = 0;
}

void SweepController::restart() {
  speed_rad_s_ = 0.0;
  if (phase_ == SweepPhase::kSweeping || phase_ == SweepPhase::kApproaching) begin_approach();
}

void SweepController::observe(StampNs stamp_ns, double angle_rad) {
  if (angle_rad_) find_crossings(stamp_ns, angle_rad);
  seen_ns_ = stamp_ns;
  angle_rad_ = angle_rad;
  if (phase_ != SweepPhase::kApproaching) return;
  if (park_rad_) {
    if (std::abs(*park_rad_ - angle_rad) < config_.tolerance_rad) phase_ = SweepPhase::kParked;
    return;
  }
  if (stroke_.direction == 0.0)
    stroke_.direction =
        std::abs(angle_rad - stroke_.low_rad) <= std::abs(angle_rad - stroke_.high_rad) ? 1.0 : -1.0;
  const double run_up_from_rad = stroke_.first_rad() - stroke_.direction * run_up_rad();
  if (std::abs(run_up_from_rad - angle_rad) < config_.tolerance_rad) running_up_ = true;
}

void SweepController::find_crossings(StampNs stamp_ns, double angle_rad) {
  const auto passed = [&](double level_rad) { return stroke_.direction * (angle_rad - level_rad) >= 0.0; };
  if (phase_ == SweepPhase::kApproaching && running_up_ && passed(stroke_.first_rad())) {
    start_ns_ = crossing_ns(seen_ns_, *angle_rad_, stamp_ns, angle_rad, stroke_.first_rad());
    phase_ = SweepPhase::kSweeping;
  }
  if (phase_ == SweepPhase::kSweeping && passed(stroke_.last_rad())) {
    end_ns_ = crossing_ns(seen_ns_, *angle_rad_, stamp_ns, angle_rad, stroke_.last_rad());
    phase_ = SweepPhase::kDone;
    running_up_ = false;
  }
}

double SweepController::towards(double target_rad) const {
  const double way_rad = target_rad - *angle_rad_;
  const double distance_rad = std::abs(way_rad);
  // Fast far away, braking in time, and easing in over the last bit so that the delay of the loop makes no
  // oscillation.
  const double speed =
      std::min({config_.max_speed_rad_s, std::sqrt(config_.acceleration_rad_s2 * distance_rad),
                distance_rad / (2.0 * config_.settle_s)});
  return std::copysign(speed, way_rad);
}

double SweepController::speed(double dt_s) {
  if (!angle_rad_) return 0.0;
  double target_rad_s = 0.0;
  if (phase_ == SweepPhase::kSweeping || running_up_) {
    target_rad_s = stroke_.direction * stroke_.speed_rad_s;
  } else if (park_rad_) {
    target_rad_s = towards(*park_rad_);
  } else if (phase_ == SweepPhase::kApproaching && stroke_.direction != 0.0) {
    target_rad_s = towards(stroke_.first_rad() - stroke_.direction * run_up_rad());
  }
  const double change = config_.acceleration_rad_s2 * dt_s;
  speed_rad_s_ = std::clamp(target_rad_s, speed_rad_s_ - change, speed_rad_s_ + change);
  return speed_rad_s_;
}

}  // namespace enfilade::motor_control
