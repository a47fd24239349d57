// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "components/roomDetector/core/zeroed_array.hpp"
#include "interfaces/geometry/pose2.hpp"

namespace enfilade::room_detector {

/// What a wall pays where the grid has seen free space: a charge for each cell. Free cells near something
/// occupied are noise of a wall and cost nothing. The least charge within a distance, by blocks of cells,
/// bounds whole stretches of wall at once. least_within() keeps what it works out: const or not, one thread
/// at a time.
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
  /// No charge lies farther from a point.
  double farthest_m(const Point2& p) const;

  static constexpr int kBits = 16;
  static constexpr double kOne = 1 << kBits;

  /// Lower bounds of the charges around each place, 255 at most.
  struct Least {
    const std::uint8_t* charges;
    std::size_t stride;
    int at(std::int32_t fixed_x, std::int32_t fixed_y) const {
      const int shift = kBits + kBlockBits;
      return charges[static_cast<std::size_t>(fixed_x >> shift) * stride +
                     static_cast<std::size_t>(fixed_y >> shift)];
    }
  };
  /// No more than any charge at most so far away along each axis; 0 where that is very far. Valid until the
  /// map changes. Of threads that ask only one may be the first to ask for a distance.
  Least least_within(double distance_m) const;

 private:
  static constexpr int kBlockBits = 1;
  static constexpr int kReaches = 16;  // in blocks; beyond, nothing is known of charges

  /// Rows and columns from ≤ i < to, of cells or of blocks of them.
  struct Box {
    int from_x = 1 << 20, to_x = 0, from_y = 1 << 20, to_y = 0;
    bool is_empty() const { return from_x >= to_x; }
    void add(const Box& other) {
      from_x = std::min(from_x, other.from_x);
      to_x = std::max(to_x, other.to_x);
      from_y = std::min(from_y, other.from_y);
      to_y = std::max(to_y, other.to_y);
    }
    Box grown(int by, int end) const {
      return {std::max(0, from_x - by), std::min(end, to_x + by), std::max(0, from_y - by),
              std::min(end, to_y + by)};
    }
  };
  /// The least charges up to `reach` blocks away; what the box holds is out of date.
  struct Eroded {
    int reach = 0;
    Box stale;
    ZeroedArray<std::uint8_t> charges;
  };

  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(x) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(y);
  }
  bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < side_ && y < side_; }
  void allocate();
  void price(int x, int y);
  void price_around(int x, int y, int reach);
  bool is_near_occupied(int x, int y) const;
  std::size_t block_at(int x, int y) const {
    return static_cast<std::size_t>(x) * static_cast<std::size_t>(blocks_) + static_cast<std::size_t>(y);
  }
  static Box blocks_of(const Box& cells);
  void update_least() const;
  void erode(Eroded& eroded) const;

  double cell_m_;
  int first_x_, first_y_;
  int side_, blocks_;
  double per_free_ = 0.0;
  int near_cells_ = 0;
  ZeroedArray<std::int16_t> free_, charge_;
  ZeroedArray<std::uint8_t> occupied_;
  Box known_;                                    // cells with votes
  mutable Box changed_;                          // cells whose charge has, since least_ was
  mutable ZeroedArray<std::uint8_t> least_;      // charge of each block
  mutable std::array<Eroded, kReaches> eroded_;  // by reach
  mutable ZeroedArray<std::uint8_t> nothing_;    // one row, for distances beyond them
  mutable std::vector<std::uint8_t> by_row_;
};

}  // namespace enfilade::room_detector
