// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "components/roomDetector/core/corner_blocks.hpp"
#include "components/roomDetector/core/hough_space.hpp"
#include "components/roomDetector/core/near_votes.hpp"
#include "components/roomDetector/core/plane_search.hpp"
#include "components/roomDetector/core/vote_strips.hpp"

namespace enfilade::room_detector {

/// Upper bounds of what rectangles around the robot score in one plane, from blocks of lines.
///
/// With the robot in (d_r, p_r), eq. 5 is a sum over the four corners of the rectangle: to corner (d₁₂, d₄₁)
/// belong the stretches of the two walls between it and the axes d = d_r and p = p_r, and what lies inside
/// between it and the robot. A block of d₁₂ and a block of d₄₁ bound that term: the most any line of the
/// block holds up to the farther end, less the tolls up to the nearer end, the least charges for free space
/// on the way, and what lies inside the smallest rectangle.
class CornerBounds {
 public:
  static constexpr int kBlock = VoteStrips::kBlock;

  /// All lines of planes around the robot with these reaches, in blocks: those beyond `near_bins`, a multiple
  /// of kBlock, in larger ones.
  static CornerChoice everything(const Reaches& reaches, int near_bins);
  /// After this several threads may build bounds, each its own, until the space changes.
  static void prepare(const HoughSpace& space);
  /// These corners count in the next planes. Blocks begin at distances 1 + k · kBlock; larger ones than
  /// kBlock are far and the last of their side.
  void lay_out(const HoughSpace& space, const NearVotes& votes, const CornerChoice& choice);
  /// Looks for rectangles of a plane that may have `score`; no walls hold more than `most_of_walls`, less
  /// tolls. First charges are taken by whole blocks, then by quarters.
  void build(const HoughSpace& space, int angle, const HoughSpace::Bins& robot, int score, int most_of_walls,
             const PlaneLimits& limits);

  /// Looks again, for a higher score.
  void raise(int score, const PlaneLimits& limits) { corners_.solve(score, limits.d, limits.p); }
  /// No rectangle of the plane scores more, if that is as much as the score asked for.
  int bound() const { return corners_.bound(); }
  /// All corners that can be part of a rectangle with that score.
  const CornerChoice& choice() const { return corners_.choice(); }
  /// What this took, in microseconds or so.
  int work() const { return 1 + strips_.cast_votes() / 150 + corner_count_ / 14; }
  /// Whether far lines are among them, of which little is known.
  bool has_far() const;
  /// Those of the best blocks: a good place to look first.
  CornerChoice best() const { return corners_.best(); }

 private:
  /// d is 0 for d₁₂, p is 0 for d₄₁.
  struct Quadrant {
    int d, p;
    int rows = 0, columns = 0;  // of blocks, out to the last corner that can matter
    int d_side() const { return d; }
    int p_side() const { return kD41 + p; }
  };
  /// The plane at hand.
  struct Plane {
    const HoughSpace& space;
    int angle;
    HoughSpace::Bins robot;
  };

  void bound_far_lines(const Plane& plane);
  void add_corners(const Plane& plane, Quadrant q, int groups);
  void sum_inside(Quadrant& q);
  void find_reach(Quadrant& q);
  void charge(const Plane& plane, const Quadrant& q, int groups);
  template <int groups>
  void hold(int side, int half, int rows);
  void put_together(const Quadrant& q);

  /// How many squares of kBlock bins lie between the robot and a block.
  int squares_before(int side, int block) const {
    return (may_.blocks[side][static_cast<std::size_t>(block)].nearest - 1) / kBlock;
  }
  /// Of a row of walls: near blocks, padded, then far ones.
  int stride(int side) const { return strips_.width(side) + may_.count(side) - strips_.near(side); }
  /// Where a block stands in such a row.
  int column(int side, int block) const {
    return block < strips_.near(side) ? block : strips_.width(side) + block - strips_.near(side);
  }

  const NearVotes* votes_ = nullptr;
  int toll_ = 0;
  int corner_count_ = 0;
  int most_inside_ = 0;  // of a rectangle that may have the score
  CornerChoice asked_, may_;
  std::array<std::vector<int>, 4> near_at_;  // by side and square: the near block there; -1 = none
  VoteStrips strips_;
  CornerBlocks corners_;
  std::array<std::vector<int>, 4> far_;  // half of the most that a line of each far block holds
  std::vector<int> reach_;               // of one quadrant: blocks of p that matter, by block of d
  std::vector<int> inside_;              // of one quadrant, row by row
  using Bytes = std::vector<std::uint8_t>;
  std::array<Bytes, 2> charge_;            // by axis: for each square along, its groups of lines, all blocks
  std::array<std::vector<int>, 2> walls_;  // by axis: row by row along, over the blocks of lines
  std::vector<int> spent_;
};

}  // namespace enfilade::room_detector
