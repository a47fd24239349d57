// SPDX-License-Identifier: Apache-2.0
#include "tools/room/outline_sight.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace enfilade::room {
namespace {

constexpr double kOnWall_m = 0.15;     // so near the outline is on it
constexpr double kOnWall_cells = 2.0;  // at least
constexpr double kBridged_m = 0.6;     // hidden stretches so short are what is beside them
constexpr double kNarrow_m = 0.6;      // narrower than any door
constexpr double kDoor_m = 1.2;        // wider than a door
constexpr double kNothing_m = 0.05;    // and wider than an error of the grid
constexpr double kNiche_m = 0.8;       // furniture is no deeper
constexpr double kSeenWall_m = 0.6;    // of a wall: enough to say where it is
constexpr double kFurniture_m = 1.5;   // furniture is no longer
constexpr double kSameThing_m = 0.3;   // between neighbouring sights
constexpr double kGrazing = 0.05;      // sine of the flattest angle at which outline is measured

enum class Seen { kWall, kOpen, kFurniture, kNothing };

bool is_hidden(Seen seen) { return seen == Seen::kFurniture || seen == Seen::kNothing; }

/// Where one sight crosses the outline, in the frame of the rectangle.
struct Crossing {
  Seen seen = Seen::kNothing;
  double length_m = 0.0;        // of outline that this sight stands for
  Point2 end = Point2::Zero();  // of the sight
  double beyond_m = 0.0;        // by which the end lies outside
  bool meets = false;
};

/// Neighbouring crossings that tell the same.
struct Stretch {
  Seen seen = Seen::kNothing;
  std::size_t from = 0, count = 0;
  double length_m = 0.0;
};

class Look {
 public:
  Look(const Rectangle& outline, const Panorama& panorama)
      : outline_(outline), half_(0.5 * outline.width_m, 0.5 * outline.height_m) {
    on_wall_m_ = std::max(kOnWall_m, kOnWall_cells * panorama.resolution_m);
    const Pose2 T_outline_zone = outline.pose().inverse();
    const Point2 near = 0.99 * half_;  // a robot on the very outline is taken in
    const Point2 robot = (T_outline_zone * panorama.place).cwiseMax(-near).cwiseMin(near);
    for (const Sight& sight : panorama.sights)
      crossings_.push_back(
          cross(robot, rotate(-outline.yaw_rad, sight.direction), sight, panorama.step_rad()));
    bridge(stretches());
  }

  OutlineSight tell() const {
    OutlineSight told;
    std::array<double, 4> seen_m{};
    for (const Crossing& c : crossings_) {
      if (c.seen == Seen::kWall && std::abs(c.beyond_m) <= on_wall_m_) seen_m[wall_at(c.end)] += c.length_m;
      if (is_hidden(c.seen)) told.hidden_m += c.length_m;
      if (c.seen != Seen::kOpen) continue;
      told.open_m += c.length_m;
      if (c.meets && c.beyond_m > on_wall_m_ && c.beyond_m < kNiche_m) told.niches_m += c.length_m;
    }
    for (std::size_t wall = 0; wall < 4; ++wall) {
      told.seen_shares += seen_m[wall] / outline_.wall_length_m(static_cast<int>(wall));
      told.bare_walls += std::max(0.0, 1.0 - seen_m[wall] / kSeenWall_m);
    }
    for (const Stretch& s : stretches()) {
      if (s.seen == Seen::kOpen) told.wide_m += std::max(0.0, s.length_m - kDoor_m);
      if (s.seen == Seen::kOpen && s.length_m > kNothing_m && s.length_m < kNarrow_m) ++told.narrow_gaps;
      if (s.seen == Seen::kFurniture) told.long_furniture_m += std::max(0.0, extent_of(s) - kFurniture_m);
    }
    return told;
  }

 private:
  Crossing cross(const Point2& robot, const Point2& direction, const Sight& sight, double step_rad) const {
    const auto until = [&](int axis) {
      const double to_m = (direction[axis] > 0.0 ? half_[axis] : -half_[axis]) - robot[axis];
      return std::abs(direction[axis]) > 1e-12 ? to_m / direction[axis] : std::numeric_limits<double>::max();
    };
    const int axis = until(0) < until(1) ? 0 : 1;
    const double distance_m = until(axis);
    Crossing c{.meets = sight.meets};
    c.length_m = distance_m * step_rad / std::max(kGrazing, std::abs(direction[axis]));
    c.end = robot + sight.range_m * direction;
    c.beyond_m = (c.end.cwiseAbs() - half_).maxCoeff();
    if (c.beyond_m > on_wall_m_)
      c.seen = Seen::kOpen;
    else if (c.meets)
      c.seen = c.beyond_m >= -on_wall_m_ ? Seen::kWall : Seen::kFurniture;
    return c;
  }

  /// The wall whose line a point near the outline lies on.
  std::size_t wall_at(const Point2& p) const {
    const Point2 beyond = p.cwiseAbs() - half_;
    const int axis = beyond.x() > beyond.y() ? 0 : 1;
    return static_cast<std::size_t>(axis + (p[axis] > 0.0 ? 0 : 2));
  }

  std::size_t after(std::size_t i, std::size_t steps) const { return (i + steps) % crossings_.size(); }

  std::vector<Stretch> stretches() const {
    const std::size_t count = crossings_.size();
    std::size_t first = 0;
    while (first < count && crossings_[first].seen == crossings_[after(first, count - 1)].seen) ++first;
    std::vector<Stretch> found;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = after(first, k);
      if (found.empty() || found.back().seen != crossings_[i].seen)
        found.push_back({crossings_[i].seen, i, 0, 0.0});
      ++found.back().count;
      found.back().length_m += crossings_[i].length_m;
    }
    return found;
  }

  void bridge(std::vector<Stretch> around) {
    const std::size_t count = around.size();
    for (std::size_t k = 0; count > 2 && k < count; ++k) {
      Stretch& s = around[k];
      const Seen before = around[(k + count - 1) % count].seen;
      if (!is_hidden(s.seen) || is_hidden(before) || before != around[(k + 1) % count].seen) continue;
      if (s.length_m > kBridged_m) continue;
      s.seen = before;
      for (std::size_t i = 0; i < s.count; ++i) crossings_[after(s.from, i)].seen = before;
    }
  }

  /// Length of the surface of what was met.
  double extent_of(const Stretch& s) const {
    double extent_m = 0.0;
    for (std::size_t i = 1; i < s.count; ++i) {
      const double step_m = (crossings_[after(s.from, i)].end - crossings_[after(s.from, i - 1)].end).norm();
      if (step_m < kSameThing_m) extent_m += step_m;
    }
    return extent_m;
  }

  Rectangle outline_;
  Point2 half_;
  double on_wall_m_ = kOnWall_m;
  std::vector<Crossing> crossings_;
};

}  // namespace

OutlineSight sight_of(const Rectangle& outline, const Panorama& panorama) {
  return Look(outline, panorama).tell();
}

double implausibility(const OutlineSight& sight) {
  return sight.open_m + sight.wide_m + 0.25 * sight.hidden_m + 2.0 * sight.narrow_gaps +
         4.0 * sight.niches_m - 3.0 * sight.seen_shares + 3.0 * sight.bare_walls +
         0.4 * sight.long_furniture_m;
}

}  // namespace enfilade::room
