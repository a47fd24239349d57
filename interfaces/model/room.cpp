// SPDX-License-Identifier: Apache-2.0
#include "interfaces/model/room.hpp"

namespace enfilade {

Segment segment_of(const Rectangle& rectangle, const WallInterval& interval) {
  const Segment wall = rectangle.wall(interval.wall);
  const Point2 along = wall.direction();
  return {wall.from + interval.from_m * along, wall.from + interval.to_m * along};
}

}  // namespace enfilade
