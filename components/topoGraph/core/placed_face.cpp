// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/placed_face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace enfilade::topo_graph {
namespace {

bool openings_overlap(const PlacedFace& a, const PlacedFace& b) {
  const Point2 along = a.segment.direction();
  const double from = (b.segment.from - a.segment.from).dot(along);
  const double to = (b.segment.to - a.segment.from).dot(along);
  return std::max(from, to) > 0.0 && std::min(from, to) < a.segment.length();
}

int nearest_wall(const PlacedFace& face, const Rectangle& rectangle, double max_angle_rad) {
  int best = 0;
  double best_distance = std::numeric_limits<double>::infinity();
  for (const bool must_face : {true, false}) {
    for (int wall = 0; wall < 4; ++wall) {
      const bool faces = back_to_back(face, {rectangle.wall(wall), rectangle.normal(wall)}, max_angle_rad);
      const double away = distance(face.midpoint(), rectangle.wall(wall));
      if ((must_face && !faces) || away >= best_distance) continue;
      best = wall;
      best_distance = away;
    }
    if (std::isfinite(best_distance)) break;
  }
  return best;
}

}  // namespace

PlacedFace place(const Rectangle& rectangle, const WallInterval& gap) {
  return {segment_of(rectangle, gap), rectangle.normal(gap.wall)};
}

PlacedFace place(const Room& room, const DoorFace& face) { return place(room.rectangle(), face.gap); }

bool back_to_back(const PlacedFace& a, const PlacedFace& b, double max_angle_rad) {
  return a.normal.dot(b.normal) <= -std::cos(max_angle_rad);
}

bool coincide(const PlacedFace& a, const PlacedFace& b, const FaceMatchConfig& config) {
  return back_to_back(a, b, config.max_angle_rad) &&
         (a.midpoint() - b.midpoint()).norm() <= config.max_distance_m && openings_overlap(a, b);
}

WallInterval project_on_nearest_wall(const PlacedFace& face, const Rectangle& rectangle,
                                     double max_angle_rad) {
  const int wall = nearest_wall(face, rectangle, max_angle_rad);
  const double length_m = rectangle.wall_length_m(wall);
  const double width_m = std::min(face.segment.length(), length_m);
  const Segment line = rectangle.wall(wall);
  const double middle_m = (face.midpoint() - line.from).dot(line.direction());
  const double from_m = std::clamp(middle_m - 0.5 * width_m, 0.0, length_m - width_m);
  return {static_cast<std::uint8_t>(wall), from_m, from_m + width_m};
}

}  // namespace enfilade::topo_graph
