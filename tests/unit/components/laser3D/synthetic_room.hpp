// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "interfaces/model/sensing.hpp"

namespace enfilade::laser_3d {

/// A furnished room, 4 × 3 m and 2.5 m high, seen by a scanner `height_m` over the floor: range noise σ 8 mm,
/// a third of the floor under a table, some stray points below the floor.
inline std::vector<Point3f> synthetic_room(double height_m, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 0.008);
  std::uniform_real_distribution<double> along_x(-2.0, 2.0), along_y(-1.5, 1.5), up(0.0, 2.5), unit(0.0, 1.0);
  std::vector<Point3f> points;
  const auto add = [&](double x, double y, double z) {
    points.push_back({static_cast<float>(x + noise(random)), static_cast<float>(y + noise(random)),
                      static_cast<float>(z - height_m + noise(random))});
  };
  for (int i = 0; i < 4000; ++i) {
    const double x = along_x(random), y = along_y(random);
    const bool under_table = x > 0.6;
    add(x, y, under_table ? 0.72 : 0.0);
    add(along_x(random), along_y(random), 2.5);
    for (int k = 0; k < 2; ++k) {
      add(along_x(random), unit(random) < 0.5 ? -1.5 : 1.5, up(random));
      add(unit(random) < 0.5 ? -2.0 : 2.0, along_y(random), up(random));
    }
  }
  for (int i = 0; i < 60; ++i) add(along_x(random), along_y(random), -0.8 * unit(random));
  return points;
}

}  // namespace enfilade::laser_3d
