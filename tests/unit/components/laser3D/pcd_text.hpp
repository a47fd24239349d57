// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "interfaces/model/sensing.hpp"

/// Writers of PCD files for tests.
namespace enfilade::laser_3d {

template <class T>
std::string raw(T value) {
  std::string out(sizeof value, '\0');
  std::memcpy(out.data(), &value, sizeof value);
  return out;
}

/// x y z float, in this order.
inline std::string pcd_header(std::size_t points, const std::string& encoding) {
  const std::string count = std::to_string(points);
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F "
         "F\nCOUNT 1 1 1\nWIDTH " +
         count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA " + encoding + "\n";
}

inline std::string ascii_pcd(const std::vector<Point3f>& points) {
  std::string out = pcd_header(points.size(), "ascii");
  for (const Point3f& p : points)
    out += std::to_string(p.x_m) + " " + std::to_string(p.y_m) + " " + std::to_string(p.z_m) + "\n";
  return out;
}

inline std::string binary_pcd(const std::vector<Point3f>& points) {
  std::string out = pcd_header(points.size(), "binary");
  for (const Point3f& p : points) out += raw(p.x_m) + raw(p.y_m) + raw(p.z_m);
  return out;
}

/// An LZF stream of literals alone.
inline std::string pack_literally(const std::string& plain) {
  std::string out;
  for (std::size_t at = 0; at < plain.size(); at += 32) {
    const std::string part = plain.substr(at, 32);
    out += static_cast<char>(part.size() - 1) + part;
  }
  return out;
}

inline std::string compressed_pcd(const std::vector<Point3f>& points) {
  std::string x, y, z;
  for (const Point3f& p : points) {
    x += raw(p.x_m);
    y += raw(p.y_m);
    z += raw(p.z_m);
  }
  const std::string plain = x + y + z, packed = pack_literally(plain);
  return pcd_header(points.size(), "binary_compressed") + raw(static_cast<std::uint32_t>(packed.size())) +
         raw(static_cast<std::uint32_t>(plain.size())) + packed;
}

}  // namespace enfilade::laser_3d
