// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>

#include "interfaces/model/motion.hpp"

namespace enfilade::grid_builder {

/// When the sweep motor travelled, put together from the states of the motors.
class SweepWindows {
 public:
  void take(const MotorState& state);
  void clear() { windows_.clear(); }

  /// Whether a sweep was under way at `stamp_ns`. While the end of the newest sweep is not known yet, it
  /// counts as under way.
  bool contain(StampNs stamp_ns) const;

 private:
  struct Window {
    StampNs start_ns = 0;
    std::optional<StampNs> end_ns;
    StampNs last_seen_ns = 0;  ///< newest state that spoke of this sweep
  };

  void close_open_window();

  std::deque<Window> windows_;
};

}  // namespace enfilade::grid_builder
