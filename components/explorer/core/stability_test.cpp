// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/stability_test.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "components/explorer/core/rectangle_naming.hpp"

namespace enfilade::explorer {

long count_open_doors(const RoomEstimate& estimate) {
  return std::count_if(estimate.doors.begin(), estimate.doors.end(),
                       [](const DoorEstimate& door) { return door.state == DoorState::kOpen; });
}

StabilityTest::StabilityTest(const StabilityTestConfig& config) : config_(config) {
  if (!(config.shift_m > 0.0 && config.angle_deg > 0.0)) {
    throw std::invalid_argument("StabilityTest: shift_m and angle_deg must be greater than 0");
  }
}

void StabilityTest::reset() {
  last_.reset();
  stable_ = false;
}

bool StabilityTest::update(const RoomEstimate& estimate) {
  if (!estimate.found) {
    reset();
    return false;
  }
  stable_ = false;
  if (last_) {
    const auto shifts_m = wall_shifts_m(*last_, estimate.rectangle);
    const double turned_rad = std::abs(wrap_to_quarter(estimate.rectangle.yaw_rad - last_->yaw_rad));
    stable_ = std::all_of(shifts_m.begin(), shifts_m.end(),
                          [&](double s) { return std::abs(s) < config_.shift_m; }) &&
              turned_rad < radians(config_.angle_deg) && open_doors_ == count_open_doors(estimate);
  }
  last_ = estimate.rectangle;
  open_doors_ = count_open_doors(estimate);
  return stable_;
}

}  // namespace enfilade::explorer
