// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/roll_interpolator.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace enfilade::laser_3d {

RollInterpolator::RollInterpolator(const RollInterpolatorConfig& config) : config_(config) {
  if (config.history < 2 || !(config.max_gap_s > 0.0))
    throw std::invalid_argument("roll: history must be at least 2 and max_gap_s greater than 0");
}

void RollInterpolator::add(StampNs stamp_ns, double roll_rad) {
  if (!samples_.empty() && stamp_ns <= samples_.back().stamp_ns) return;
  samples_.push_back({stamp_ns, roll_rad});
  if (samples_.size() > static_cast<std::size_t>(config_.history)) samples_.pop_front();
}

std::deque<RollInterpolator::Sample>::const_iterator RollInterpolator::first_not_before(
    StampNs stamp_ns) const {
  return std::lower_bound(samples_.begin(), samples_.end(), stamp_ns,
                          [](const Sample& sample, StampNs stamp) { return sample.stamp_ns < stamp; });
}

std::optional<double> RollInterpolator::angle_at(StampNs stamp_ns) const {
  const auto after = first_not_before(stamp_ns);
  if (after == samples_.end()) return std::nullopt;
  if (after->stamp_ns == stamp_ns) return after->roll_rad;
  if (after == samples_.begin()) return std::nullopt;
  const auto before = std::prev(after);
  const StampNs gap_ns = after->stamp_ns - before->stamp_ns;
  if (seconds(gap_ns) > config_.max_gap_s) return std::nullopt;
  const double share = static_cast<double>(stamp_ns - before->stamp_ns) / static_cast<double>(gap_ns);
  return before->roll_rad + share * (after->roll_rad - before->roll_rad);
}

Coverage RollInterpolator::coverage(StampNs from_ns, StampNs to_ns) const {
  if (samples_.empty() || samples_.back().stamp_ns < to_ns) return Coverage::kNotYet;
  if (samples_.front().stamp_ns > from_ns) return Coverage::kUnknown;
  auto after = first_not_before(from_ns);
  if (after != samples_.begin() && after->stamp_ns > from_ns) --after;
  for (; after->stamp_ns < to_ns; ++after)
    if (seconds(std::next(after)->stamp_ns - after->stamp_ns) > config_.max_gap_s) return Coverage::kUnknown;
  return Coverage::kKnown;
}

}  // namespace enfilade::laser_3d
