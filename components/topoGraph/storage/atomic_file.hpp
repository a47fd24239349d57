// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

#include "components/topoGraph/storage/disk.hpp"

namespace enfilade::topo_graph {

/// Replaces `path` by `text` so that at any moment, also after a power cut, the file is the old one or the
/// new one as a whole, and returns once the new one is on the disk. The old one stays under the name
/// `old_one`, in the same folder. Missing folders are created. Throws std::system_error naming the file.
void write_atomically(const std::filesystem::path& path, std::string_view text,
                      const std::filesystem::path& old_one, Disk& disk = real_disk());

/// The folder of a file.
std::filesystem::path folder_of(const std::filesystem::path& path);

}  // namespace enfilade::topo_graph
