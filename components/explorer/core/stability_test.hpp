// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "interfaces/model/room.hpp"

namespace enfilade::explorer {

struct StabilityTestConfig {
  double shift_m = 0.05;  ///< a wall that moved farther has changed
  double angle_deg = 2.0;
};

/// Section IV: a model is real when further scanning changes nothing. Compares each estimate with the one
/// after the sweep before.
class StabilityTest {
 public:
  explicit StabilityTest(const StabilityTestConfig& config);

  void reset();
  /// Takes the estimate after a sweep. True where the one before had the same walls and as many open doors.
  bool update(const RoomEstimate& estimate);
  bool stable() const { return stable_; }

 private:
  StabilityTestConfig config_;
  std::optional<Rectangle> last_;
  long open_doors_ = 0;
  bool stable_ = false;
};

long count_open_doors(const RoomEstimate& estimate);

}  // namespace enfilade::explorer
