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

  /// Prepares the bounds of one plane for lines within `reaches`, as far as it takes to tell whether it holds
  /// `score`.
  void build(const HoughSpace& space, int angle, const HoughSpace::Bins& robot, const Reaches& reaches,
             int score);

  /// How much there is to sum up.
  int bins() const { return static_cast<int>(strips_.size()); }
  /// No rectangle of the plane scores more.
  int bound() const { return bound_; }
  /// Lines farther out than this are no part of a rectangle with the score that was asked for.
  Reaches reaches() const { return reaches_; }
  /// The lines out to the best blocks: a good place to look first.
  Reaches best_reaches() const { return best_; }

 private:
  enum { kD12, kD34, kD41, kD23 };

  /// The lines on one side of the robot, with their votes on both sides of its other axis.
  struct Side {
    int lines = 0;
    int blocks = 0;                         // of lines, kBlock in each
    std::array<int, 2> strips{};            // where those before and behind the axis begin in strips_
    std::array<std::vector<int>, 2> walls;  // most of any line: by block along, then block of lines
    std::vector<int> most;                  // over all rectangles with a line of the block
  };

  void lay_out(int bins, const Reaches& reaches, int margin);
  void lay_out_inside(int axis, int bins, int margin);
  void lay_out_lines(int axis, int bins);
  void lay_out_along(int side, int bins);
  void cast(const HoughSpace& space, int angle, const HoughSpace::Bins& robot);
  void sum_strips(Side& side, int half, int blocks_along, int toll);
  void add_corners(const HoughSpace& space, int angle, const HoughSpace::Bins& robot, int d_side, int p_side);
  int blocks_along(int side, int half) const { return sides_[side < kD41 ? kD41 + half : half].blocks; }
  void bound_sides();
  void bound_pairs(int score);
  int best_block(int d12, int d34, int half) const;

  std::array<Side, 4> sides_;
  std::vector<int> strips_;
  std::array<std::vector<int>, 2> line_;       // by axis: of each bin from the robot's, its place in a strip
  std::array<std::vector<int>, 4> along_;      // by side: of each bin across, likewise, its strip
  std::array<std::vector<int>, 2> inside_of_;  // by axis: its row or column in inside_
  std::vector<int> inside_;                    // interior votes by block of d, block of p
  int inside_width_ = 0, margin_ = -1;
  std::array<std::array<std::vector<int>, 2>, 2> corners_;  // by quadrant: bounds by block of d, block of p
  std::vector<int> votes_before_, charges_before_;
  Reaches laid_out_, best_, reaches_;
  int bound_ = 0;
};

}  // namespace enfilade::room_detector
