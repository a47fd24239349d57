// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "components/topoGraph/core/topo_state.hpp"

/// The words of the map file that its writer and its reader must agree on.
namespace enfilade::topo_graph::names {

inline constexpr std::string_view kFormat = "enfilade-map";
/// 2 has `records`, and may have a journal beside it.
inline constexpr std::uint64_t kVersion = 2;
/// The last line: a file without it was cut off.
inline constexpr std::string_view kEnd = "end: enfilade-map\n";

inline constexpr std::string_view kJournalFormat = "enfilade-map-journal";
inline constexpr int kJournalVersion = 1;

/// By the value of DoorKind.
inline constexpr std::array<std::string_view, 4> kDoorKinds{"unresolved", "passage", "exit", "blocked"};
/// By the value of PlaceKind.
inline constexpr std::array<std::string_view, 2> kPlaceKinds{"building", "floor"};
/// By the value of RequestKind.
inline constexpr std::array<std::string_view, 3> kRequestKinds{"fix_room", "enter_zone", "mark_door"};

}  // namespace enfilade::topo_graph::names
