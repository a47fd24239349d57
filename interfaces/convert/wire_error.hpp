// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <stdexcept>

namespace enfilade::wire {

/// What came from the wire is no message of its type, or what shall go there does not fit. One sentence for
/// people.
struct WireError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Most that is believed of a message from the wire; more is a corrupted or hostile one.
inline constexpr std::size_t kMaxMessageBytes = std::size_t{64} << 20;
inline constexpr std::size_t kMaxBeams = 100'000;
inline constexpr std::size_t kMaxPoints = 4'000'000;
inline constexpr std::size_t kMaxPointFields = 64;
inline constexpr std::size_t kMaxJoints = 1'000;
inline constexpr std::size_t kMaxTransforms = 10'000;
inline constexpr std::size_t kMaxGridCells = 8'000'000;
inline constexpr std::size_t kMaxCellHits = 1'000'000;
inline constexpr std::size_t kMaxMapCells = 60'000'000;
inline constexpr std::size_t kMaxOctreeBytes = 60'000'000;
inline constexpr std::size_t kMaxOutlinePoints = 10'000;
inline constexpr std::size_t kMaxRooms = 10'000;
inline constexpr std::size_t kMaxDoors = 100'000;
inline constexpr std::size_t kMaxLinks = 100'000;
inline constexpr std::size_t kMaxTextBytes = 65'536;

/// Throws WireError if `count` is more than `most`; `what` is the field, in the plural.
void check_count(std::size_t count, std::size_t most, const char* what);

}  // namespace enfilade::wire
