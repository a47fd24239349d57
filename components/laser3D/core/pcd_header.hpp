// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "components/laser3D/core/text_lines.hpp"
#include "interfaces/model/sensing.hpp"

namespace enfilade::laser_3d {

enum class PcdEncoding { kAscii, kBinary, kBinaryCompressed };

/// Where one coordinate is found.
struct PcdCoordinate {
  std::size_t column = 0;  ///< among the numbers of an ascii row
  std::size_t offset = 0;  ///< in a binary row, bytes
  bool is_double = false;

  std::size_t size() const { return is_double ? 8 : 4; }
};

struct PcdHeader {
  std::array<PcdCoordinate, 3> xyz;
  std::size_t columns = 0;    ///< numbers in an ascii row
  std::size_t row_bytes = 0;  ///< bytes of a binary row
  std::size_t points = 0;
  Point3f origin;  ///< of VIEWPOINT: where the scanner stood, in the frame of the points
  PcdEncoding encoding = PcdEncoding::kAscii;
  std::size_t data_offset = 0;
  int data_line = 0;  ///< number of the line DATA
};

/// Throws std::runtime_error where the header is cut off, contradicts itself, or lacks x, y or z.
PcdHeader read_pcd_header(const FileBytes& file);

}  // namespace enfilade::laser_3d
