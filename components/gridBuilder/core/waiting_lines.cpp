// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/waiting_lines.hpp"

#include <algorithm>
#include <stdexcept>

namespace enfilade::grid_builder {

WaitingLines::WaitingLines(int max_lines) : max_lines_(static_cast<std::size_t>(std::max(max_lines, 0))) {
  if (max_lines < 1) throw std::invalid_argument("max_waiting_lines must be at least 1");
}

void WaitingLines::add_hits(const PointCloud& cloud) {
  BaseLine& line = line_at(cloud.stamp_ns);
  line.has_hits = true;
  line.hits.insert(line.hits.end(), cloud.points.begin(), cloud.points.end());
}

void WaitingLines::add_free_ends(const PointCloud& cloud) {
  BaseLine& line = line_at(cloud.stamp_ns);
  line.free_ends.insert(line.free_ends.end(), cloud.points.begin(), cloud.points.end());
}

BaseLine WaitingLines::pop() {
  BaseLine line = std::move(lines_.front());
  lines_.pop_front();
  return line;
}

BaseLine& WaitingLines::line_at(StampNs stamp_ns) {
  const auto same =
      std::find_if(lines_.rbegin(), lines_.rend(), [=](const BaseLine& l) { return l.stamp_ns == stamp_ns; });
  if (same != lines_.rend()) return *same;
  if (lines_.size() == max_lines_) {
    lines_.pop_front();
    ++overflowed_;
  }
  lines_.emplace_back().stamp_ns = stamp_ns;
  return lines_.back();
}

}  // namespace enfilade::grid_builder
