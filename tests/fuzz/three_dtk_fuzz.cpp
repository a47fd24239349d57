// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "components/laser3D/core/point_file.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace enfilade;
  try {
    const laser_3d::ScannedPoints read = laser_3d::read_3dtk({"scan.3d", fuzz::text_of(data, size)});
    const auto within_reach = [](const Point3f& p) { return std::hypot(p.x_m, p.y_m, p.z_m) < 32.01; };
    fuzz::must(std::all_of(read.points.begin(), read.points.end(), within_reach),
               "all points are finite and nearer than the sentinel");
  } catch (const std::runtime_error&) {
  }
  return 0;
}
