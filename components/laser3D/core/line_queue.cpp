// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/line_queue.hpp"

#include <stdexcept>
#include <utility>

namespace enfilade::laser_3d {

StampNs beam_stamp_ns(const LaserScan& scan, std::size_t beam) {
  return scan.stamp_ns + from_seconds(static_cast<double>(beam) * static_cast<double>(scan.time_increment_s));
}

LineQueue::LineQueue(const LineQueueConfig& config) : config_(config) {
  if (config.capacity < 1) throw std::invalid_argument("queue: capacity must be at least 1");
}

void LineQueue::push(LaserScan scan) {
  if (waiting_.size() == static_cast<std::size_t>(config_.capacity)) {
    waiting_.pop_front();
    ++dropped_;
  }
  waiting_.push_back(std::move(scan));
}

std::optional<RolledLine> LineQueue::pop(const RollInterpolator& roll) {
  while (!waiting_.empty()) {
    const LaserScan& next = waiting_.front();
    const std::size_t beams = next.ranges_m.size();
    const StampNs end_ns = beam_stamp_ns(next, beams == 0 ? 0 : beams - 1);
    const Coverage coverage = roll.coverage(next.stamp_ns, end_ns);
    if (coverage == Coverage::kNotYet) return std::nullopt;
    RolledLine line{.scan = std::move(waiting_.front()), .roll_rad = {}};
    waiting_.pop_front();
    if (coverage == Coverage::kUnknown) {
      ++dropped_;
      continue;
    }
    line.roll_rad.reserve(beams);
    for (std::size_t i = 0; i < beams; ++i)
      line.roll_rad.push_back(roll.angle_at(beam_stamp_ns(line.scan, i)).value());
    return line;
  }
  return std::nullopt;
}

}  // namespace enfilade::laser_3d
