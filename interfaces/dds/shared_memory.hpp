// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace enfilade {

inline const std::filesystem::path kSharedMemoryFolder = "/dev/shm";

/// Why a segment of `bytes` cannot be had in `folder`, found out by making one; nothing where it can.
std::optional<std::string> why_no_shared_memory(std::size_t bytes,
                                                const std::filesystem::path& folder = kSharedMemoryFolder);

/// Removes what killed processes of this user have left behind: files of Fast DDS in `folder` that no living
/// process maps or holds open. For the start of a deployment. Returns how many.
int remove_stale_segments(const std::filesystem::path& folder = kSharedMemoryFolder);

}  // namespace enfilade
