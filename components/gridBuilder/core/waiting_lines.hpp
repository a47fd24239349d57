// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "interfaces/model/sensing.hpp"

namespace enfilade::grid_builder {

/// What has come of one scan line, in the base frame.
struct BaseLine {
  StampNs stamp_ns = 0;
  bool has_hits = false;  ///< whether rt/points of this line has come, be it empty
  std::vector<Point3f> hits;
  std::vector<Point3f> free_ends;
};

/// Lines that wait for odometry, in the order they came. The two clouds of one line meet here if both wait.
class WaitingLines {
 public:
  explicit WaitingLines(int max_lines);

  void add_hits(const PointCloud& cloud);
  void add_free_ends(const PointCloud& cloud);
  void clear() { lines_.clear(); }

  const BaseLine* front() const { return lines_.empty() ? nullptr : &lines_.front(); }
  BaseLine pop();
  /// How many lines were given up because too many waited.
  std::size_t overflowed() const { return overflowed_; }

 private:
  BaseLine& line_at(StampNs stamp_ns);

  std::size_t max_lines_;
  std::deque<BaseLine> lines_;
  std::size_t overflowed_ = 0;
};

}  // namespace enfilade::grid_builder
