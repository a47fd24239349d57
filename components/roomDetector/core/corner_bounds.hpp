// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "components/roomDetector/core/hough_space.hpp"
#include "components/roomDetector/core/plane_search.hpp"

namespace enfilade::room_detector {

/// How many lines on each side of the robot's bin can be walls, in bins: 0 … n - 1 away from it.
struct Reaches {
  int d12 = 0, d34 = 0, d41 = 0, d23 = 0;
  bool is_empty() const { return d12 <= 0 || d34 <= 0 || d41 <= 0 || d23 <= 0; }
  bool operator==(const Reaches&) const = default;
};

/// Upper bounds of what rectangles around the robot score in one plane, from blocks of kBlock bins.
///
/// With the robot in (d_r, p_r), eq. 5 is a sum over the four corners of the rectangle: to corner (d₁₂, d₄₁)
/// belong the stretches of the two walls between it and the axes d = d_r and p = p_r, and what lies inside
/// between it and the robot. A block of d₁₂ and a block of d₄₁ bound that term: the most any line of the
/// block holds up to the farther end, less the tolls up to the nearer end, the least charges for free space
/// on the way, and what lies inside the smallest rectangle.
class CornerBounds {
 public:
  static constexpr int kBlock = 8;

  /// Prepares the bounds of one plane for lines within `reaches`.
  void build(const HoughSpace& space, int angle, const HoughSpace::Bins& robot, const Reaches& reaches);

  /// No rectangle of the plane scores more.
  int bound() const { return bound_; }
  /// Lines farther out than this are no part of a rectangle that scores `score` or more.
  Reaches reaches_for(int score) const;
  /// The lines out to the best blocks: a good place to look first.
  Reaches best_reaches() const { return best_; }

 private:
  /// The lines on one side of the robot, with their votes on both sides of its other axis.
  struct Side {
    int lines = 0, blocks = 0;
    std::array<std::vector<int>, 2> strips;  // [before or behind the axis], by block along, then by line
    std::array<std::vector<int>, 2> walls;   // most of any line, by block of lines, then block along
  };
  enum { kD12, kD34, kD41, kD23 };

  void cast(const HoughSpace& space, int angle, const HoughSpace::Bins& robot);
  void cast_on_lines(Side& side, int line, int other_distance, bool is_behind, int count);
  void sum_strips(Side& side, int half, int blocks_along, int toll);
  void add_quadrant(const HoughSpace& space, int angle, const HoughSpace::Bins& robot, int d_side,
                    int p_side);
  void combine();

  std::array<Side, 4> sides_;
  std::array<std::array<std::vector<int>, 2>, 2> inside_;   // by quadrant: interior votes by block
  std::array<std::array<std::vector<int>, 2>, 2> corners_;  // by quadrant: bounds by block of d, block of p
  std::vector<int> pair_, line_d_, line_p_;
  std::array<std::vector<int>, 4> best_with_;  // the most with a line of each block, by side
  Reaches best_;
  int bound_ = 0;
};

}  // namespace enfilade::room_detector
