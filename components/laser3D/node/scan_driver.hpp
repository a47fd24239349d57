// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "interfaces/model/sensing.hpp"

namespace enfilade::laser_3d {

/// The way to one kind of range finder. Lines arrive on the component's executor, in the order of their
/// stamps.
class ScanDriver {
 public:
  virtual ~ScanDriver() = default;
  virtual void start(std::function<void(const LaserScan&)> on_line) = 0;
};

}  // namespace enfilade::laser_3d
