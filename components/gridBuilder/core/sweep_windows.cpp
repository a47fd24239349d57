// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/sweep_windows.hpp"

#include <algorithm>

namespace enfilade::grid_builder {
namespace {

constexpr std::size_t kSweepsRemembered = 8;

bool tells_of_sweep(const MotorState& s) {
  return s.sweep_start_ns != 0 && (s.phase == SweepPhase::kSweeping || s.phase == SweepPhase::kDone);
}

}  // namespace

void SweepWindows::take(const MotorState& state) {
  if (!tells_of_sweep(state)) {
    close_open_window();
    return;
  }
  if (windows_.empty() || windows_.back().start_ns != state.sweep_start_ns) {
    close_open_window();
    windows_.push_back({state.sweep_start_ns, std::nullopt, state.stamp_ns});
    if (windows_.size() > kSweepsRemembered) windows_.pop_front();
  }
  Window& window = windows_.back();
  window.last_seen_ns = state.stamp_ns;
  if (state.phase == SweepPhase::kDone && state.sweep_end_ns != 0) window.end_ns = state.sweep_end_ns;
}

bool SweepWindows::contain(StampNs stamp_ns) const {
  return std::any_of(windows_.begin(), windows_.end(), [stamp_ns](const Window& w) {
    return stamp_ns >= w.start_ns && (!w.end_ns || stamp_ns <= *w.end_ns);
  });
}

/// Its end was not told (the state that did was replaced by a newer one): only what was seen of it counts.
void SweepWindows::close_open_window() {
  if (!windows_.empty() && !windows_.back().end_ns) windows_.back().end_ns = windows_.back().last_seen_ns;
}

}  // namespace enfilade::grid_builder
