// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace enfilade::room_detector {

enum class SliceKind : std::uint8_t { kWall, kFree, kUnknown };

/// Slices from ≤ i < to.
struct Run {
  std::size_t from = 0, to = 0;
  std::size_t size() const { return to - from; }
  bool operator==(const Run&) const = default;
};

/// A stretch of wall where nothing stands, in parts: what is open, and what is left over between that and the
/// wall.
struct Gap {
  std::vector<Run> open;
  std::vector<Run> rest;
};

struct GapLengths {
  std::size_t min_open = 1;   ///< shorter free runs do not open a gap
  std::size_t tolerance = 0;  ///< so many slices not known to be free do not end a free run
  std::size_t min_rest = 1;   ///< shorter left-overs beside an open run belong to it
};

/// Maximal runs without wall, taken apart, in order.
std::vector<Gap> find_gaps(const std::vector<SliceKind>& kinds, const GapLengths& lengths);

}  // namespace enfilade::room_detector
