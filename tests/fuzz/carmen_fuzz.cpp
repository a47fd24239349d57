// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "components/laser3D/core/carmen_reader.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace enfilade;
  try {
    const laser_3d::CarmenLog log = laser_3d::read_carmen({"robot.log", fuzz::text_of(data, size)});
    fuzz::must(!log.scans.empty(), "a log that is accepted has a scan");
    for (const laser_3d::CarmenScan& scan : log.scans) {
      const auto points = laser_3d::returns_of(scan, 30.0);
      const auto finite = [](const Point2& p) { return std::isfinite(p.x()) && std::isfinite(p.y()); };
      fuzz::must(std::all_of(points.begin(), points.end(), finite), "all returns are finite");
    }
  } catch (const std::runtime_error&) {
  }
  return 0;
}
