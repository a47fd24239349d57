// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

#include "components/topoGraph/storage/disk.hpp"

namespace enfilade::topo_graph {

/// Replaces `path` by `text` so that at any moment, also after a power cut, the file is the old one or the
/// new one as a whole, and returns once the new one is on the disk. The old one stays as last_good(path).
/// Missing folders are created. Throws std::system_error naming the file.
void write_atomically(const std::filesystem::path& path, std::string_view text, Disk& disk = real_disk());

/// Where write_atomically keeps what it has replaced: "<path>.last".
std::filesystem::path last_good(const std::filesystem::path& path);

}  // namespace enfilade::topo_graph
