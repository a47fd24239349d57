// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/sweeper.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace enfilade::explorer {

Sweeper::Sweeper(const SweeperConfig& config) : config_(config) {
  if (!(config.to_rad > config.from_rad))
    throw std::invalid_argument("Sweeper: to_rad must be above from_rad");
}

void Sweeper::begin(double step_deg, StampNs now_ns) {
  speed_rad_s_ = radians(step_deg) * config_.line_rate_hz;
  begun_ns_ = now_ns;
  issued_ = false;
  attempts_ = 0;
}

SweepStatus Sweeper::update(const Observation& seen, Decision& decision) {
  if (!issued_) {
    if (seen.standing() || seconds(seen.now_ns - begun_ns_) > config_.settle_s) issue(seen, decision);
    return SweepStatus::kRunning;
  }
  const MotorState& motor = *seen.motor;
  if (motor.sweep_id == command_.sweep_id && motor.phase == SweepPhase::kDone) {
    end_ns_ = motor.sweep_end_ns;
    park(decision);
    return SweepStatus::kDone;
  }
  const double stroke_s = (config_.to_rad - config_.from_rad) / speed_rad_s_;
  if (seconds(seen.now_ns - issued_ns_) > stroke_s + config_.spare_s) {
    if (attempts_ >= config_.max_attempts) return SweepStatus::kFailed;
    issue(seen, decision);
  } else if (motor.sweep_id < command_.sweep_id && seconds(seen.now_ns - sent_ns_) > config_.repeat_s) {
    decision.sweep = command_;
    sent_ns_ = seen.now_ns;
  }
  return SweepStatus::kRunning;
}

void Sweeper::issue(const Observation& seen, Decision& decision) {
  last_id_ = std::max(last_id_, seen.motor->sweep_id) + 1;
  command_ = {.sweep_id = last_id_,
              .action = SweepAction::kSweep,
              .from_rad = config_.from_rad,
              .to_rad = config_.to_rad,
              .speed_rad_s = speed_rad_s_};
  decision.sweep = command_;
  issued_ = true;
  ++attempts_;
  issued_ns_ = sent_ns_ = seen.now_ns;
}

void Sweeper::park(Decision& decision) {
  decision.sweep = SweepCommand{.sweep_id = ++last_id_, .action = SweepAction::kPark};
}

}  // namespace enfilade::explorer
