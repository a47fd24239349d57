// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace enfilade::laser_3d {

/// No LZF stream unpacks to more than this many times its size: three bytes give at most 264.
inline constexpr std::size_t kLzfMostRatio = 88;

/// Unpacks an LZF stream, as PCD files hold it; nothing unless it is sound and unpacks to exactly
/// `unpacked_size` bytes.
///
/// The stream is a row of items. A first byte c < 32 announces c + 1 literal bytes. Otherwise c >> 5 is a
/// length L, 7 meaning that the next byte is to be added to it, and the other five bits of c, followed by one
/// more byte, are a distance D: copy L + 2 bytes from D + 1 bytes back in the output; source and target may
/// overlap.
std::optional<std::string> unpack_lzf(std::string_view packed, std::size_t unpacked_size);

}  // namespace enfilade::laser_3d
