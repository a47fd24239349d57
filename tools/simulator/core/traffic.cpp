// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/core/traffic.hpp"

#include "tools/simulator/core/shapes.hpp"

namespace enfilade::simulator {
namespace {

constexpr double kPoliteness_m = 0.05;
constexpr double kPatience_s = 4.0;

}  // namespace

Traffic::Traffic(const World& world, double robot_radius_m, double robot_height_m)
    : keep_away_m_(robot_radius_m + kPoliteness_m), height_m_(robot_height_m) {
  for (const MovingSolid& moving : world.moving) {
    walkers_.push_back({moving, moving.waypoints.size() > 1 ? 1u : 0u});
    positions_.push_back(moving.waypoints.front());
  }
  refresh_outlines();
}

void Traffic::turn_to_next(Walker& walker) {
  const std::size_t count = walker.moving.waypoints.size();
  walker.next = (walker.next + (walker.backwards ? count - 1 : 1)) % count;
}

Point2 Traffic::advanced(Walker& walker, Point2 position, double way_m) const {
  const std::vector<Point2>& waypoints = walker.moving.waypoints;
  for (std::size_t visited = 0; visited <= waypoints.size(); ++visited) {
    const Point2 ahead = waypoints[walker.next] - position;
    if (ahead.norm() > way_m) return position + way_m * ahead.normalized();
    way_m -= ahead.norm();
    position = waypoints[walker.next];
    turn_to_next(walker);
  }
  return position;
}

void Traffic::step(double dt_s, const Point2& robot) {
  if (empty()) return;
  for (std::size_t i = 0; i < walkers_.size(); ++i) {
    Walker ahead = walkers_[i];
    const Solid& solid = ahead.moving.solid;
    const Point2 position = advanced(ahead, positions_[i], ahead.moving.speed_m_s * dt_s);
    const double now_m = distance(robot, shifted(solid.base, positions_[i]));
    const double then_m = distance(robot, shifted(solid.base, position));
    if (in_the_way(solid, height_m_) && then_m < keep_away_m_ && then_m < now_m) {
      wait(walkers_[i], dt_s);
      continue;
    }
    ahead.waited_s = 0.0;
    walkers_[i] = std::move(ahead);
    positions_[i] = position;
  }
  refresh_outlines();
}

void Traffic::wait(Walker& walker, double dt_s) {
  walker.waited_s += dt_s;
  if (walker.waited_s < kPatience_s) return;
  walker.waited_s = 0.0;
  walker.backwards = !walker.backwards;
  turn_to_next(walker);
}

void Traffic::refresh_outlines() {
  outlines_.clear();
  for (std::size_t i = 0; i < walkers_.size(); ++i)
    if (in_the_way(walkers_[i].moving.solid, height_m_))
      outlines_.push_back(shifted(walkers_[i].moving.solid.base, positions_[i]));
}

}  // namespace enfilade::simulator
