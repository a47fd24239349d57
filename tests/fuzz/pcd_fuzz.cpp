// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "components/laser3D/core/point_file.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace enfilade;
  try {
    const laser_3d::ScannedPoints read = laser_3d::read_pcd({"cloud.pcd", fuzz::text_of(data, size)});
    const auto finite = [](const Point3f& p) {
      return std::isfinite(p.x_m) && std::isfinite(p.y_m) && std::isfinite(p.z_m);
    };
    fuzz::must(std::all_of(read.points.begin(), read.points.end(), finite) && finite(read.origin),
               "all points are finite");
  } catch (const std::runtime_error&) {
  }
  return 0;
}
