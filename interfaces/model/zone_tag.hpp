// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace enfilade {

/// Nanoseconds on the clock of the system: wall time since the epoch, or simulated time since the world's
/// start.
using StampNs = std::int64_t;

constexpr double seconds(StampNs stamp_ns) { return 1e-9 * static_cast<double>(stamp_ns); }
constexpr StampNs from_seconds(double s) { return static_cast<StampNs>(s * 1e9 + (s < 0 ? -0.5 : 0.5)); }

/// What a message was made from. A reader drops a message whose tag is not its own current one.
struct ZoneTag {
  std::uint32_t zone_id =
      0;  ///< the space modelled since the last door was crossed; issued by topoGraph, from 1
  std::uint32_t grid_epoch = 0;  ///< new at every clear or restart of gridBuilder
  std::uint32_t odom_boot = 0;   ///< new at every restart of motorControl

  bool operator==(const ZoneTag&) const = default;
};

}  // namespace enfilade
