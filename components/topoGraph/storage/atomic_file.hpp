// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace enfilade::topo_graph {

/// Replaces `path` by `text` so that at any moment, also after a power cut, the file is the old one or the
/// new one as a whole, and returns once the new one is on the disk. Missing folders are created. Throws
/// std::system_error naming the file.
void write_atomically(const std::filesystem::path& path, std::string_view text);

}  // namespace enfilade::topo_graph
