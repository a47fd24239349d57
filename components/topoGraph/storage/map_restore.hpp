// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "components/topoGraph/storage/map_file.hpp"

namespace enfilade::topo_graph {

/// The newest good map that the files of a damaged one still give: the map with its journal as far as that is
/// good, or the map before with the journals that continue it.
std::optional<MapFile> find_last_good(const std::filesystem::path& path);

/// " (…)" where there is one; else nothing.
std::string offer_last_good(const std::filesystem::path& path);

/// Writes the last good map in place of the damaged one, which stays, with its journal, as "<path>.damaged".
/// Throws MapFileError where the map is not damaged, or there is no good one.
MapFile restore_last_good(const std::filesystem::path& path);

}  // namespace enfilade::topo_graph
