// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "interfaces/geometry/pose2.hpp"

namespace enfilade::room_detector {

/// Which of the free space about the robot hangs together with it. A room is in one piece: what was seen
/// free at the heights of the wall band, but only through a door, under its lintel, is cut off from the robot
/// at these heights by the wall over the door, and does not belong to the room.
///
/// Columns are looked at in blocks of two by two: a block with a wall in it is closed, one without and with
/// a free column is open, all others are not known and closed too. Open blocks that touch hang together,
/// except where two walls meet between them: of a thin wall askew to the grid two blocks often share no more
/// than a corner.
class ConnectedSpace {
 public:
  enum class Kind : std::uint8_t { kUnknown, kOpen, kWall };

  /// Columns begin at multiples of `cell_m`; those within `reach_m` of `origin`, by each axis, are kept.
  ConnectedSpace(double cell_m, const Point2& origin, double reach_m);

  /// Column (x, y) of the grid is no longer `from` but `to`. All are unknown at first.
  void change(int x, int y, Kind from, Kind to);
  /// Finds out what hangs together with `robot`.
  void flood(const Point2& robot);
  /// Whether the column lies in open space apart from the robot, as of the last flood.
  bool is_apart(int x, int y) const {
    const int i = index_of(x, y);
    return i >= 0 && knows_robot_ && blocks_[static_cast<std::size_t>(i)].is_open() &&
           reached_[static_cast<std::size_t>(i)] == 0;
  }

 private:
  struct Block {
    std::uint8_t open = 0, walls = 0;  ///< columns of it
    bool is_open() const { return open > 0 && walls == 0; }
  };

  /// -1 = beyond reach.
  int index_of(int x, int y) const {
    const int bx = (x - first_x_) >> 1, by = (y - first_y_) >> 1;
    return bx > 0 && by > 0 && bx < side_ - 1 && by < side_ - 1 ? bx * side_ + by : -1;
  }
  int start_near(int index) const;

  double cell_m_;
  int first_x_, first_y_;
  int side_;  ///< of the map, in blocks; those on its rim stay closed
  std::vector<Block> blocks_;
  std::vector<std::uint8_t> reached_;
  std::vector<int> front_;  // what the last flood has reached, in that order
  bool knows_robot_ = false, is_stale_ = false;
};

}  // namespace enfilade::room_detector
