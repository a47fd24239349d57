// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/node/simulator_scan_driver.hpp"

#include <utility>

#include "interfaces/topics/topics.hpp"

namespace enfilade::laser_3d {

void SimulatorScanDriver::start(std::function<void(const LaserScan&)> on_line) {
  bus_.subscribe<LaserScan>(topics::kSimScan, std::move(on_line));
}

}  // namespace enfilade::laser_3d
