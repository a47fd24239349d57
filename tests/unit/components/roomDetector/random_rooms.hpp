// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <random>
#include <vector>

#include "tests/unit/components/roomDetector/sim_room.hpp"

namespace enfilade::room_detector::test {

/// Furnished rooms with two doors and a corridor whose walls prolong those of the room.
class RandomRooms {
 public:
  explicit RandomRooms(unsigned seed) : random_(seed) {}

  double uniform(double a, double b) {
    return a + (b - a) * static_cast<double>(random_() >> 8) / 16777216.0;
  }
  int integer(int a, int b) { return a + static_cast<int>(random_() % static_cast<unsigned>(b - a + 1)); }

  SimRoom next() {
    const double w = uniform(2.6, 6.5), h = uniform(2.6, 6.5);
    RoomBuilder builder(w, h, uniform(2.5, 2.8));
    builder.at({uniform(-1.5, 1.5), uniform(-1.5, 1.5), uniform(-kPi, kPi)});
    const Rectangle r{0, 0, 0, w, h};
    const int first = integer(0, 3);
    std::vector<Point2> thresholds;
    for (const int wall : {first, (first + integer(1, 3)) % 4}) {
      const double from = uniform(0.3, r.wall_length_m(wall) - 1.4);
      const WallInterval gap{static_cast<std::uint8_t>(wall), from, from + uniform(0.75, 1.0)};
      builder.door(wall, gap.from_m, gap.to_m);
      thresholds.push_back(segment_of(r, gap).midpoint());
    }
    add_furniture(builder, w, h, thresholds);
    add_neighbour(builder, w, h);
    return builder.build();
  }

 private:
  void add_furniture(RoomBuilder& builder, double w, double h, const std::vector<Point2>& thresholds) {
    for (int i = integer(4, 8); i > 0; --i) {
      const double sx = uniform(0.3, 1.4), sy = uniform(0.3, 0.7), top = uniform(0.4, 2.0);
      const bool along_x = integer(0, 1);
      const double bx = along_x ? sx : sy, by = along_x ? sy : sx;
      double x = uniform(-0.5 * w, 0.5 * w - bx), y = uniform(-0.5 * h, 0.5 * h - by);
      if (integer(0, 3) > 0)
        (along_x ? y : x) =
            integer(0, 1) ? (along_x ? -0.5 * h : -0.5 * w) : (along_x ? 0.5 * h - by : 0.5 * w - bx);
      const auto covers = [&](const Point2& p, double margin) {
        return p.x() > x - margin && p.x() < x + bx + margin && p.y() > y - margin && p.y() < y + by + margin;
      };
      const bool is_in_the_way =
          covers(Point2::Zero(), 0.9) ||
          std::any_of(thresholds.begin(), thresholds.end(), [&](const Point2& p) { return covers(p, 0.8); });
      if (!is_in_the_way) builder.box(x, y, x + bx, y + by, top);
    }
  }
  /// The room next door shares two lines of wall with this one.
  void add_neighbour(RoomBuilder& builder, double w, double h) {
    const double x = 0.5 * w + kWallThickness, far = x + uniform(1.5, 5.0), t = kWallThickness;
    builder.box(x, 0.5 * h, far, 0.5 * h + t, 2.5)
        .box(x, -0.5 * h - t, far, -0.5 * h, 2.5)
        .box(far, -0.5 * h, far + t, 0.5 * h, 2.5);
  }

  std::mt19937 random_;
};

}  // namespace enfilade::room_detector::test
