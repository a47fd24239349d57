// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/wall_profile.hpp"

#include <cmath>

namespace enfilade::room_detector {

std::vector<WallSlice> profile_wall(const ColumnMap& map, const Rectangle& rectangle, int wall) {
  const double r = map.resolution_m();
  const Segment segment = rectangle.wall(wall);
  const Point2 along = segment.direction(), outwards = rectangle.normal(wall);
  static const Column kNothing;
  const auto column = [&](double s, double n) -> const Column& {
    const Column* found = map.find(segment.from + s * along + n * outwards);
    return found ? *found : kNothing;
  };
  std::vector<WallSlice> slices;
  for (double s = 0.5 * r; s < segment.length(); s += r) {
    const Column &inner = column(s, -r), &plane = column(s, 0.0), &outer = column(s, r);
    const Levels occupied = inner.occupied | plane.occupied | outer.occupied;
    slices.push_back({occupied, plane.free & outer.free & ~occupied});
  }
  return slices;
}

SliceShares shares_of(const std::vector<WallSlice>& slices, std::size_t from, std::size_t to,
                      const Levels& band) {
  const double all = static_cast<double>((to - from) * band.count());
  if (all == 0.0) return {};
  int occupied = 0, free = 0;
  for (std::size_t i = from; i < to; ++i) {
    occupied += count_of(slices[i].occupied & band);
    free += count_of(slices[i].free & band);
  }
  return {static_cast<double>(occupied) / all, static_cast<double>(free) / all};
}

}  // namespace enfilade::room_detector
