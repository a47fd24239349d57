// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "interfaces/model/topological_map.hpp"

namespace enfilade::topo_graph {

/// A door's face with the outward normal of its wall, in the map frame.
struct PlacedFace {
  Segment segment;
  Point2 normal = Point2::UnitX();

  Point2 midpoint() const { return segment.midpoint(); }
};

PlacedFace place(const Rectangle& rectangle, const WallInterval& gap);
PlacedFace place(const Room& room, const DoorFace& face);

struct FaceMatchConfig {
  double max_distance_m = 0.6;    ///< between the midpoints of the two faces of one door
  double max_angle_rad = 0.5236;  ///< 30°: by which the walls of the two faces may miss being parallel
};

/// Whether the normals are opposite within `max_angle_rad`.
bool back_to_back(const PlacedFace& a, const PlacedFace& b, double max_angle_rad);

/// Whether a and b can be the two faces of one door: back to back, midpoints near, openings overlapping.
bool coincide(const PlacedFace& a, const PlacedFace& b, const FaceMatchConfig& config);

/// The face's opening on the wall of `rectangle` nearest to it among those back to back with it (among all
/// where none is): pushed into the wall where it would stick out. It is how a room must see a door through
/// which the robot came, seen or not.
WallInterval project_on_nearest_wall(const PlacedFace& face, const Rectangle& rectangle,
                                     double max_angle_rad);

}  // namespace enfilade::topo_graph
