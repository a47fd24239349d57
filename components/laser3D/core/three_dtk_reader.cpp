// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "components/laser3D/core/point_file.hpp"

namespace enfilade::laser_3d {
namespace {

constexpr double kSentinelRange_m = 32.0;
constexpr double kMetresPerUnit = 0.01;

}  // namespace

ScannedPoints read_3dtk(const FileBytes& file) {
  ScannedPoints read;
  TextLines lines(file.bytes);
  while (const auto line = lines.next()) {
    const auto columns = words(*line);
    if (columns.empty() || columns[0].starts_with('#')) continue;
    if (columns.size() < 3) reject_line(file, lines.number(), "x y z expected, three numbers in centimetres");
    const auto x = to_number(columns[0]), y = to_number(columns[1]), z = to_number(columns[2]);
    if (!x || !y || !z) reject_line(file, lines.number(), "x y z expected, and one of them is no number");
    const double forward_m = kMetresPerUnit * *z, left_m = -kMetresPerUnit * *x, up_m = kMetresPerUnit * *y;
    const double range_m = std::hypot(forward_m, left_m, up_m);
    if (!(range_m < kSentinelRange_m)) continue;  // NaN too
    read.points.push_back(
        {static_cast<float>(forward_m), static_cast<float>(left_m), static_cast<float>(up_m)});
  }
  if (!lines.at_end())
    reject_line(file, lines.number() + 1, "the line has no end: the file is cut off; get it again");
  return read;
}

}  // namespace enfilade::laser_3d
