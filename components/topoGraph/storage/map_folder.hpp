// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "components/topoGraph/storage/disk.hpp"

/// The files of one map, all in one folder:
///
///   map.yaml               the map
///   map.yaml.journal       what has changed since
///   map.yaml.last          the map before, and
///   map.yaml.last.journal  what changed it into the present one
///
/// Whatever happens between two of the steps below, the map with its journal is the newest one: a journal
/// that a new map holds already is passed over.
namespace enfilade::topo_graph {

std::filesystem::path journal_of(const std::filesystem::path& path);
std::filesystem::path last_good(const std::filesystem::path& path);

/// Nothing where there is no such file. Throws MapFileError where it cannot be read, or is too large.
std::optional<std::string> read_if_there(const std::filesystem::path& path);

/// Writes the map, and keeps the one before as last_good. Like all below: durable on return, and throws
/// std::system_error.
void write_map_file(const std::filesystem::path& path, std::string_view text, Disk& disk = real_disk());

/// Begins a journal for the map that was written, and keeps the one before with last_good.
void begin_journal(const std::filesystem::path& path, std::string_view header, Disk& disk = real_disk());

/// Keeps the journal, if there is one, with last_good.
void end_journal(const std::filesystem::path& path, Disk& disk = real_disk());

/// Gives a map with its journal another name.
void move_map(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace enfilade::topo_graph
