// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "interfaces/model/room.hpp"

/// A small world of boxes, here and in the headers beside it: enough to show the detector rooms whose truth
/// is known.
namespace enfilade::room_detector::test {

struct Box {
  Eigen::Vector3d low, high;
};

/// A furnished room in its own frame, placed in the zone.
struct SimRoom {
  Pose2 T_zone_room;
  double width_m = 4.0, height_m = 3.0, ceiling_m = 2.6;
  std::vector<Box> boxes;
  std::vector<WallInterval> doors;  ///< true ones

  Rectangle rectangle() const {
    return {T_zone_room.yaw_rad, T_zone_room.x_m, T_zone_room.y_m, width_m, height_m};
  }
};

inline constexpr double kWallThickness = 0.15;

/// An opening in a wall between two heights.
struct Opening {
  WallInterval gap;
  double bottom_m = 0.0, top_m = 2.03;
};

class RoomBuilder {
 public:
  RoomBuilder(double width_m, double height_m, double ceiling_m) {
    room_.width_m = width_m;
    room_.height_m = height_m;
    room_.ceiling_m = ceiling_m;
  }

  RoomBuilder& at(const Pose2& T_zone_room) {
    room_.T_zone_room = T_zone_room;
    return *this;
  }
  RoomBuilder& door(int wall, double from_m, double to_m, double top_m = 2.03) {
    room_.doors.push_back({static_cast<std::uint8_t>(wall), from_m, to_m});
    openings_.push_back({room_.doors.back(), 0.0, top_m});
    return *this;
  }
  RoomBuilder& window(int wall, double from_m, double to_m) {
    openings_.push_back({{static_cast<std::uint8_t>(wall), from_m, to_m}, 0.9, 2.0});
    return *this;
  }
  RoomBuilder& box(double x0, double y0, double x1, double y1, double top_m, double bottom_m = 0.0) {
    room_.boxes.push_back({{x0, y0, bottom_m}, {x1, y1, top_m}});
    return *this;
  }

  SimRoom build() {
    for (int wall = 0; wall < 4; ++wall) add_wall(wall);
    const double x = 0.5 * room_.width_m + 6.0, y = 0.5 * room_.height_m + 6.0;
    room_.boxes.push_back({{-x, -y, -0.2}, {x, y, 0.0}});
    room_.boxes.push_back({{-x, -y, room_.ceiling_m}, {x, y, room_.ceiling_m + 0.2}});
    return room_;
  }

 private:
  void add_wall(int wall) {
    std::vector<Opening> openings;
    for (const Opening& o : openings_) {
      if (o.gap.wall == wall) openings.push_back(o);
    }
    std::sort(openings.begin(), openings.end(),
              [](const Opening& a, const Opening& b) { return a.gap.from_m < b.gap.from_m; });
    const Rectangle r{0.0, 0.0, 0.0, room_.width_m, room_.height_m};
    double at = -kWallThickness;
    for (const Opening& o : openings) {
      add_part(r, wall, at, o.gap.from_m, 0.0, room_.ceiling_m);
      add_part(r, wall, o.gap.from_m, o.gap.to_m, 0.0, o.bottom_m);
      add_part(r, wall, o.gap.from_m, o.gap.to_m, o.top_m, room_.ceiling_m);
      at = o.gap.to_m;
    }
    add_part(r, wall, at, r.wall_length_m(wall) + kWallThickness, 0.0, room_.ceiling_m);
  }

  void add_part(const Rectangle& r, int wall, double from_m, double to_m, double bottom_m, double top_m) {
    if (top_m <= bottom_m) return;
    const Segment s = r.wall(wall);
    const Point2 a = s.from + from_m * s.direction(),
                 b = s.from + to_m * s.direction() + kWallThickness * r.normal(wall);
    room_.boxes.push_back({{std::min(a.x(), b.x()), std::min(a.y(), b.y()), bottom_m},
                           {std::max(a.x(), b.x()), std::max(a.y(), b.y()), top_m}});
  }

  SimRoom room_;
  std::vector<Opening> openings_;
};

/// Distance along a ray to the nearest box, room frame.
inline double cast(const std::vector<Box>& boxes, const Eigen::Vector3d& from,
                   const Eigen::Vector3d& direction) {
  double nearest = std::numeric_limits<double>::infinity();
  const Eigen::Vector3d inverse = direction.cwiseInverse();
  for (const Box& box : boxes) {
    const Eigen::Array3d a = (box.low - from).cwiseProduct(inverse).array(),
                         b = (box.high - from).cwiseProduct(inverse).array();
    const double enter = a.min(b).maxCoeff(), leave = a.max(b).minCoeff();
    if (leave >= enter && enter > 0.0 && enter < nearest) nearest = enter;
  }
  return nearest;
}

}  // namespace enfilade::room_detector::test
