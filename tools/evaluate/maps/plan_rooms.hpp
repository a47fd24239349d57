// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "interfaces/geometry/rectangle.hpp"
#include "tools/simulator/world/grey_image.hpp"

namespace enfilade::evaluate {

/// A room of a floor plan, in metres from the lower left corner of the image.
struct PlanRoom {
  Rectangle rectangle;  ///< the smallest that holds it, but for niches such as half a doorway
  double fill = 0.0;    ///< IoU of room and rectangle
  std::vector<Point2>
      stands;  ///< places in it with room for a robot: the roomiest, then such far from the others
};

/// The white areas of `segmentation`, from 2 m² on. The robot may stand where `plan`, of the same size, is
/// white too. Throws std::invalid_argument where they differ in size.
std::vector<PlanRoom> plan_rooms(const simulator::GreyImage& segmentation, const simulator::GreyImage& plan,
                                 double resolution_m);

/// The smallest rectangle about some points; without extent where they are less than three.
Rectangle smallest_rectangle(std::vector<Point2> points);

}  // namespace enfilade::evaluate
