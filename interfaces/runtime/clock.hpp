// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "interfaces/model/zone_tag.hpp"

namespace enfilade {

/// The time a component lives in: wall time on a robot, simulated time against the simulator.
class Clock {
 public:
  virtual ~Clock() = default;
  virtual StampNs now_ns() const = 0;
};

}  // namespace enfilade
