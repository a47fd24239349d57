// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "interfaces/geometry/pose2.hpp"

namespace enfilade::room_detector {

/// What a wall pays where the grid has seen free space: a charge for each cell. Free cells near something
/// occupied are noise of a wall and cost nothing. The least charge within a distance, by blocks of cells,
/// bounds whole stretches of wall at once.
class FreeMap {
 public:
  /// Cells begin at multiples of `cell_m`; those within `reach_m` of `origin`, by each axis, are kept.
  FreeMap(double cell_m, const Point2& origin, double reach_m);

  /// A cell with votes for free costs `per_free` times as much, unless something occupied lies at most
  /// `near_cells` away.
  void set_rule(double per_free, int near_cells);
  void add(const Point2& position, int free, int occupied);

  bool charges() const { return per_free_ > 0.0 && !charge_.empty(); }
  double cell_m() const { return cell_m_; }
  /// Position in units of 2⁻¹⁶ cells from the corner of the map.
  double fixed_x(double x_m) const { return kOne * (x_m / cell_m_ - first_x_); }
  double fixed_y(double y_m) const { return kOne * (y_m / cell_m_ - first_y_); }
  int charge_at(std::int32_t fixed_x, std::int32_t fixed_y) const {
    return charge_[at(fixed_x >> kBits, fixed_y >> kBits)];
  }

  /// No more than the least charge within the radius that `erode` was called with since the map changed.
  int least_near(std::int32_t fixed_x, std::int32_t fixed_y) const {
    const int shift = kBits + kBlockBits;
    return eroded_[static_cast<std::size_t>(fixed_x >> shift) * static_cast<std::size_t>(blocks_) +
                   static_cast<std::size_t>(fixed_y >> shift)];
  }
  void erode(double radius_m) const;

  static constexpr int kBits = 16;
  static constexpr double kOne = 1 << kBits;

 private:
  static constexpr int kBlockBits = 2;

  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(x) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(y);
  }
  bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < side_ && y < side_; }
  void price(int x, int y);
  void price_around(int x, int y, int reach);
  void note_change(int x, int y);

  double cell_m_;
  int first_x_, first_y_;
  int side_, blocks_;
  double per_free_ = 0.0;
  int near_cells_ = 0;
  std::vector<std::int16_t> free_, occupied_, charge_;
  std::vector<std::int16_t> least_;  // charge of each block
  int low_block_, high_block_ = 0;   // between them, by each axis, lie the blocks that charge
  mutable std::vector<std::int16_t> eroded_;
  mutable int eroded_reach_ = -1;  // of eroded_, in blocks; -1: the map has changed since
};

}  // namespace enfilade::room_detector
