// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "components/gridBuilder/core/sweep_windows.hpp"
#include "interfaces/model/topological_map.hpp"

namespace enfilade::grid_builder {

struct ZoneGateConfig {
  bool stationary = false;         ///< one zone for ever, every line belongs to it (replayed scans)
  bool only_during_sweeps = true;  ///< take only lines of which the motor says that it swept
};

/// Decides which grid the world is in: what zone, what epoch, and which scan lines belong to it.
///
/// The grid starts when the zone and the boot of the odometry are known, with the first epoch. Every later
/// change of one of them is the next epoch and calls for an empty grid.
class ZoneGate {
 public:
  /// `first_epoch` must not repeat between runs of the component within one run of the robot.
  ZoneGate(const ZoneGateConfig& config, std::uint32_t first_epoch);

  /// Whether a new grid starts: the caller clears and tells the world.
  [[nodiscard]] bool take(const CurrentZone& zone);
  [[nodiscard]] bool take(const MotorState& state);

  /// Whether there is a grid to put lines into.
  bool open() const { return zone_id_ && odom_boot_; }
  bool accepts(StampNs line_stamp_ns) const;
  /// Epoch 0 before the first grid.
  ZoneTag tag() const;
  std::uint64_t sequence() const { return sequence_; }
  std::uint64_t next_sequence() { return ++sequence_; }

 private:
  bool start_grid();

  ZoneGateConfig config_;
  std::uint32_t next_epoch_;
  std::uint32_t epoch_ = 0;
  std::uint64_t sequence_ = 0;
  std::optional<std::uint32_t> zone_id_, odom_boot_;
  StampNs valid_from_ns_ = 0;
  SweepWindows sweeps_;
};

}  // namespace enfilade::grid_builder
