// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/lzf.hpp"

namespace enfilade::laser_3d {
namespace {

struct BackReference {
  std::size_t length = 0;
  std::size_t distance = 0;
};

/// Reads the bytes that follow `control` and advances `at` past them.
std::optional<BackReference> read_back_reference(std::string_view packed, std::size_t& at, unsigned control) {
  const auto byte = [&](std::size_t i) {
    return static_cast<std::size_t>(static_cast<unsigned char>(packed[i]));
  };
  std::size_t length = control >> 5;
  const std::size_t bytes = length == 7 ? 2 : 1;
  if (packed.size() - at < bytes) return std::nullopt;
  if (length == 7) length += byte(at++);
  const std::size_t distance = ((control & 31u) << 8) + byte(at++) + 1;
  return BackReference{.length = length + 2, .distance = distance};
}

}  // namespace

std::optional<std::string> unpack_lzf(std::string_view packed, std::size_t unpacked_size) {
  if (unpacked_size / kLzfMostRatio > packed.size()) return std::nullopt;
  std::string out;
  out.reserve(unpacked_size);
  for (std::size_t at = 0; at < packed.size();) {
    const unsigned control = static_cast<unsigned char>(packed[at++]);
    if (control < 32) {
      const std::size_t length = control + 1;
      if (packed.size() - at < length || unpacked_size - out.size() < length) return std::nullopt;
      out.append(packed.substr(at, length));
      at += length;
      continue;
    }
    const auto reference = read_back_reference(packed, at, control);
    if (!reference || reference->distance > out.size() || unpacked_size - out.size() < reference->length)
      return std::nullopt;
    for (std::size_t i = 0; i < reference->length; ++i) out.push_back(out[out.size() - reference->distance]);
  }
  if (out.size() != unpacked_size) return std::nullopt;
  return out;
}

}  // namespace enfilade::laser_3d
