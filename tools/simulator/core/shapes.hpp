// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "interfaces/geometry/rectangle.hpp"
#include "tools/simulator/core/world.hpp"

namespace enfilade::simulator {

std::vector<Point2> outline(const Rectangle& rectangle);
/// A many-sided polygon with its corners on the circle.
std::vector<Point2> circle_outline(const Point2& centre, double diameter_m);
std::vector<Point2> shifted(std::vector<Point2> polygon, const Point2& offset);

/// Distance from `p` to the convex polygon; 0 inside.
double distance(const Point2& p, const std::vector<Point2>& polygon);

/// Whether a body on the floor that reaches up to `height_m` can touch the solid at all.
bool in_the_way(const Solid& solid, double height_m);

}  // namespace enfilade::simulator
