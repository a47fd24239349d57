// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/node/pacer.hpp"

#include <algorithm>
#include <stdexcept>

#include "tools/simulator/core/simulation.hpp"

namespace enfilade::simulator {
namespace {

constexpr StampNs kCreepPeriod_ns = 100'000'000;

}  // namespace

CreditPacer::CreditPacer(const CreditPacerConfig& config, const Clock& wall_clock)
    : config_(config), wall_clock_(wall_clock) {
  if (config.speed < 0 || config.credit_window_s <= 0 || config.credit_lifetime_s <= 0 ||
      config.wait_for_readers_s < 0)
    throw std::invalid_argument("CreditPacerConfig: times must be greater than 0");
}

void CreditPacer::hear(const SimCredit& credit) {
  credits_[credit.component_name] = {credit.done_ns, wall_clock_.now_ns()};
}

bool CreditPacer::all_readers_heard() const {
  return std::ranges::all_of(config_.readers,
                             [this](const std::string& name) { return credits_.contains(name); });
}

StampNs CreditPacer::allowed_ns(StampNs world_ns) {
  const StampNs wall_ns = wall_clock_.now_ns();
  if (asked_ns_ < 0) first_asked_ns_ = asked_ns_ = wall_ns;
  const StampNs passed_ns = std::max<StampNs>(wall_ns - asked_ns_, 0);
  asked_ns_ = wall_ns;
  if (!started_) {
    started_ = all_readers_heard() || wall_ns - first_asked_ns_ >= from_seconds(config_.wait_for_readers_s);
    paced_ns_ = static_cast<double>(world_ns);
    if (!started_) return creep(world_ns, wall_ns);
  }
  const StampNs credited = credited_ns(world_ns, wall_ns);
  if (config_.speed == 0.0) return credited;
  // Time lost while the readers were slow is not made up for beyond one window.
  const double most_ns = static_cast<double>(world_ns) + 1e9 * config_.credit_window_s;
  paced_ns_ = std::min(paced_ns_ + config_.speed * static_cast<double>(passed_ns), most_ns);
  return std::min(credited, static_cast<StampNs>(paced_ns_));
}

StampNs CreditPacer::creep(StampNs world_ns, StampNs wall_ns) {
  if (wall_ns - crept_ns_ < kCreepPeriod_ns) return world_ns;
  crept_ns_ = wall_ns;
  return world_ns + Simulation::kStep_ns;
}

StampNs CreditPacer::credited_ns(StampNs world_ns, StampNs wall_ns) const {
  StampNs slowest_ns = world_ns;
  for (const auto& [name, credit] : credits_)
    if (wall_ns - credit.heard_ns < from_seconds(config_.credit_lifetime_s))
      slowest_ns = std::min(slowest_ns, credit.done_ns);
  return slowest_ns + from_seconds(config_.credit_window_s);
}

}  // namespace enfilade::simulator
