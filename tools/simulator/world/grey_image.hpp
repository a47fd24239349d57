// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace enfilade::simulator {

/// Eight bits a pixel, row by row from the top.
struct GreyImage {
  int columns = 0, rows = 0;
  std::vector<std::uint8_t> pixels;
};

/// Reads PNG (colour is averaged, transparent parts count as half grey) or PGM (P2, P5). Throws
/// std::runtime_error with a sentence.
GreyImage read_grey_image(const std::string& file);

}  // namespace enfilade::simulator
