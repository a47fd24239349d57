// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "components/laser3D/core/lzf.hpp"
#include "components/laser3D/core/pcd_header.hpp"
#include "components/laser3D/core/point_file.hpp"

namespace enfilade::laser_3d {
namespace {

static_assert(std::endian::native == std::endian::little, "PCD's binary encodings are little endian");

void keep_if_finite(const std::array<double, 3>& xyz, std::vector<Point3f>& points) {
  const Point3f p{static_cast<float>(xyz[0]), static_cast<float>(xyz[1]), static_cast<float>(xyz[2])};
  if (std::isfinite(p.x_m) && std::isfinite(p.y_m) && std::isfinite(p.z_m)) points.push_back(p);
}

/// `at` + 8 or + 4 lies within `bytes`.
double coordinate_at(std::string_view bytes, std::size_t at, bool is_double) {
  if (is_double) {
    double value = 0.0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
  }
  float value = 0.0f;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

[[noreturn]] void reject_size(const FileBytes& file, std::size_t found, std::size_t needed) {
  reject(file, "the data after the header has " + std::to_string(found) + " bytes where " +
                   std::to_string(needed) + " are announced: the file is cut off; get it again");
}

void read_ascii(const FileBytes& file, const PcdHeader& header, std::vector<Point3f>& points) {
  const std::string_view data = std::string_view(file.bytes).substr(header.data_offset);
  TextLines lines(data);
  for (std::size_t i = 0; i < header.points; ++i) {
    const auto line = lines.next();
    const int number = header.data_line + lines.number();
    if (!line)
      reject_line(file, number + 1,
                  "the file is cut off after " + std::to_string(i) + " of " + std::to_string(header.points) +
                      " points; get it again");
    const auto row = words(*line);
    if (row.size() != header.columns)
      reject_line(
          file, number,
          std::to_string(row.size()) + " numbers where " + std::to_string(header.columns) + " belong");
    std::array<double, 3> xyz{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto value = to_number(row[header.xyz[axis].column]);
      if (!value)
        reject_line(file, number, "'" + std::string(row[header.xyz[axis].column]) + "' is no number");
      xyz[axis] = *value;
    }
    keep_if_finite(xyz, points);
  }
}

void read_binary(const FileBytes& file, const PcdHeader& header, std::vector<Point3f>& points) {
  const std::string_view data = std::string_view(file.bytes).substr(header.data_offset);
  const std::size_t needed = header.points * header.row_bytes;
  if (data.size() < needed) reject_size(file, data.size(), needed);
  points.reserve(header.points);
  for (std::size_t i = 0; i < header.points; ++i) {
    std::array<double, 3> xyz{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      xyz[axis] =
          coordinate_at(data, i * header.row_bytes + header.xyz[axis].offset, header.xyz[axis].is_double);
    keep_if_finite(xyz, points);
  }
}

/// Sizes packed and unpacked as 32-bit numbers, then an LZF stream of the fields one after the other, each
/// with all its points.
void read_compressed(const FileBytes& file, const PcdHeader& header, std::vector<Point3f>& points) {
  const std::string_view data = std::string_view(file.bytes).substr(header.data_offset);
  std::array<std::uint32_t, 2> sizes{};
  if (data.size() < sizeof sizes) reject_size(file, data.size(), sizeof sizes);
  std::memcpy(sizes.data(), data.data(), sizeof sizes);
  if (data.size() - sizeof sizes < sizes[0]) reject_size(file, data.size(), sizeof sizes + sizes[0]);
  const std::size_t needed = header.points * header.row_bytes;
  if (sizes[1] != needed)
    reject(file, "the compressed data unpack to " + std::to_string(sizes[1]) +
                     " bytes, but the header announces " + std::to_string(needed));
  const auto unpacked = unpack_lzf(data.substr(sizeof sizes, sizes[0]), needed);
  if (!unpacked) reject(file, "the compressed data are damaged; get the file again");
  points.reserve(header.points);
  for (std::size_t i = 0; i < header.points; ++i) {
    std::array<double, 3> xyz{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const PcdCoordinate& from = header.xyz[axis];
      xyz[axis] = coordinate_at(*unpacked, from.offset * header.points + i * from.size(), from.is_double);
    }
    keep_if_finite(xyz, points);
  }
}

}  // namespace

ScannedPoints read_pcd(const FileBytes& file) {
  const PcdHeader header = read_pcd_header(file);
  ScannedPoints read{.points = {}, .origin = header.origin};
  switch (header.encoding) {
    case PcdEncoding::kAscii:
      read_ascii(file, header, read.points);
      break;
    case PcdEncoding::kBinary:
      read_binary(file, header, read.points);
      break;
    case PcdEncoding::kBinaryCompressed:
      read_compressed(file, header, read.points);
      break;
  }
  return read;
}

}  // namespace enfilade::laser_3d
