// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/zone_gate.hpp"

#include <limits>

namespace enfilade::grid_builder {

ZoneGate::ZoneGate(const ZoneGateConfig& config, std::uint32_t first_epoch)
    : config_(config), next_epoch_(first_epoch) {
  if (!config.stationary) return;
  zone_id_ = 1;
  odom_boot_ = 0;
  valid_from_ns_ = std::numeric_limits<StampNs>::min();
  start_grid();
}

bool ZoneGate::take(const CurrentZone& zone) {
  if (config_.stationary || zone.zone_id == 0 || zone_id_ == zone.zone_id) return false;
  zone_id_ = zone.zone_id;
  valid_from_ns_ = zone.valid_from_ns;
  return start_grid();
}

bool ZoneGate::take(const MotorState& state) {
  if (config_.stationary) return false;
  const bool new_boot = odom_boot_ != state.odom_boot;
  if (new_boot) sweeps_.clear();
  sweeps_.take(state);
  odom_boot_ = state.odom_boot;
  return new_boot && start_grid();
}

bool ZoneGate::accepts(StampNs line_stamp_ns) const {
  if (config_.stationary) return true;
  if (!open() || line_stamp_ns < valid_from_ns_) return false;
  return !config_.only_during_sweeps || sweeps_.contain(line_stamp_ns);
}

ZoneTag ZoneGate::tag() const { return {zone_id_.value_or(0), epoch_, odom_boot_.value_or(0)}; }

bool ZoneGate::start_grid() {
  if (!open()) return false;
  epoch_ = next_epoch_++;
  sequence_ = 0;
  return true;
}

}  // namespace enfilade::grid_builder
