// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "components/laser3D/node/scan_driver.hpp"
#include "interfaces/bus/bus.hpp"

namespace enfilade::laser_3d {

/// The range finder of the simulated robot.
class SimulatorScanDriver : public ScanDriver {
 public:
  explicit SimulatorScanDriver(Bus& bus) : bus_(bus) {}

  void start(std::function<void(const LaserScan&)> on_line) override;

 private:
  Bus& bus_;
};

}  // namespace enfilade::laser_3d
