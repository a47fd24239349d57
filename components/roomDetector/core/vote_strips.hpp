// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "components/roomDetector/core/corner_choice.hpp"
#include "components/roomDetector/core/near_votes.hpp"

namespace enfilade::room_detector {

/// The votes of one plane along some of its lines, summed up outward from the robot by blocks of lines
/// across. Of far lines, and of what near lines hold beyond the last near block, only the sums of whole lines
/// are known.
///
/// Going round the contour, each wall has its first corner and not its last, and so has each of its halves
/// before and behind the robot. Along a wall on d₃₄ or d₄₁ distances from the robot therefore count from the
/// bin behind it on, along d₁₂ and d₂₃ from the robot's own.
class VoteStrips {
 public:
  static constexpr int kBlock = 8;   ///< the most lines that a near block has
  static constexpr int kGroups = 2;  ///< of lines in a block, half of them each

  /// Of each side the first `near` blocks are near. Votes are at most `span` bins away from the robot.
  void lay_out(const LineBlocks& blocks, const std::array<int, 4>& near, int margin, int span);
  void cast(const NearVotes& votes, const HoughSpace& space, int angle, const HoughSpace::Bins& robot);

  /// How many votes the last plane took.
  int cast_votes() const { return cast_votes_; }
  int near(int side) const { return near_[side]; }
  /// Near blocks are padded to this many, so that rows can be worked off many at a time.
  int width(int side) const { return width_[side]; }
  /// No fewer than the most votes that any line of a group holds from the robot to the end of a block along,
  /// before (half 0) or behind it: one for each near block of lines, in units of 2^scale_bits.
  std::span<const std::int16_t> most(int side, int half, int along, int group) const;
  /// The same, in votes, however far along.
  std::span<const int> most_beyond(int side, int half, int group) const;
  /// Interior votes that lie inside every rectangle with corners in these blocks or farther out, and not
  /// inside all with corners nearer.
  std::span<const int> inside(int d_side, int d_block) const;
  int inside_column(int p_side) const { return p_side == kD41 ? 0 : count_[kD41]; }

 private:
  /// The lines of one direction: a row for each block along them, kBlock runs of `width` lines for each side.
  struct Axis {
    int stride = 0;
    std::array<int, 2> rows{};
    std::vector<int> column_of, row_of;  // by bin from the robot's, plus span_
    std::vector<std::int16_t> strips;
    std::array<std::vector<std::int16_t>, 2> sums;  // of all rows before and behind the robot
  };

  /// With the bins of the line they lie on, and along it.
  struct Votes {
    const int *line, *along;
    const std::int16_t* scaled;
    int size;
  };

  void lay_out_axis(int axis, const LineBlocks& blocks);
  void lay_out_columns(int side, const std::vector<LineBlock>& blocks);
  void lay_out_rows(int side, const std::vector<LineBlock>& blocks);
  void lay_out_inside(int side, const std::vector<LineBlock>& blocks, int margin);
  void add_strips(Axis& axis, const Votes& votes, int line_robot, int along_robot, int shifted);
  void sum_up(int axis);
  void raise_most(int side, int half, int along, const std::int16_t* sum);
  void look_beyond(int side, std::span<const int> line_sums, int robot, int scale_bits);
  int first_column(int side) const { return side % 2 ? kBlock * width_[side - 1] : 0; }
  std::size_t index(int half, int along, int side) const;
  /// Place in a table by bin: `away` bins before or behind the robot's.
  std::size_t place(int side, int away) const {
    return static_cast<std::size_t>(side % 2 ? span_ + away : span_ - away);
  }

  int span_ = 0, reach_bins_ = 0, cast_votes_ = 0;
  bool has_beyond_ = false;
  LineBlocks blocks_;
  std::array<int, 4> near_{}, count_{}, width_{};
  std::array<Axis, 2> axes_;
  std::array<std::vector<std::int16_t>, 4> most_;
  std::array<std::vector<int>, 4> beyond_;
  std::array<std::vector<int>, 2> inside_of_;  // by axis: row or column in inside_, by bin from the robot's
  std::vector<int> inside_;
  int inside_width_ = 0;
};

}  // namespace enfilade::room_detector
