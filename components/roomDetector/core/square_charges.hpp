// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "components/roomDetector/core/hough_space.hpp"

namespace enfilade::room_detector {

/// The least charge for free space in each square of `size` lines of d and as many of p, counted outward from
/// the robot to one of its four sides. The first square begins beside the robot's bin.
class SquareCharges {
 public:
  SquareCharges(const HoughSpace& space, int angle, const HoughSpace::Bins& robot, bool is_behind_d,
                bool is_behind_p, int size)
      : least_(space.free_map().least_within(half_side_m(space, angle, size))) {
    const HoughSpace::BinCentres centres = space.bin_centres(angle);
    const int d_step = is_behind_d ? 1 : -1, p_step = is_behind_p ? 1 : -1;
    // The middle of the first square, in halves of a bin.
    const int d = 2 * robot.d + d_step * (size + 1), p = 2 * robot.p + p_step * (size + 1);
    x_ = centres.x + (d * centres.x_by_d - p * centres.y_by_d) / 2;
    y_ = centres.y + (d * centres.y_by_d + p * centres.x_by_d) / 2;
    x_by_d_ = d_step * size * centres.x_by_d;
    y_by_d_ = d_step * size * centres.y_by_d;
    x_by_p_ = -p_step * size * centres.y_by_d;
    y_by_p_ = p_step * size * centres.x_by_d;
  }

  /// After this several threads may look at such squares, of any plane, until the space changes.
  static void prepare(const HoughSpace& space, int size) {
    for (int a = 0; a < space.lattice().angles(); ++a)
      space.free_map().least_within(half_side_m(space, a, size));
  }

  int at(int d, int p) const {
    return least_.at(x_ + d * x_by_d_ + p * x_by_p_, y_ + d * y_by_d_ + p * y_by_p_);
  }

 private:
  /// How far the centres of bins are from the middle of their square, along the axes of the map.
  static double half_side_m(const HoughSpace& space, int angle, int size) {
    constexpr double kRounding_bins = 0.05;  // of places in the map of free space, and more
    const HoughSpace::Direction& n = space.direction(angle);
    return (0.5 * (size - 1) + kRounding_bins) * space.lattice().step_m() *
           (std::abs(n.cos) + std::abs(n.sin));
  }

  FreeMap::Least least_;
  std::int32_t x_, y_, x_by_d_, y_by_d_, x_by_p_, y_by_p_;
};

}  // namespace enfilade::room_detector
