// SPDX-License-Identifier: Apache-2.0
#include "tools/room/outline_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "tools/room/outline_sight.hpp"

namespace enfilade::room {
namespace {

constexpr double kBin_m = 0.05, kSurfaceReach_m = 16.0;
constexpr std::size_t kBins = static_cast<std::size_t>(2.0 * kSurfaceReach_m / kBin_m);
constexpr std::size_t kApart = 3;          // bins between two lines
constexpr double kLeastSurface_m = 0.3;    // that makes a line
constexpr double kAlong = 0.35;            // sine of the angle by which a surface may differ from a line
constexpr std::size_t kNeighbour = 2;      // sights on either side that tell which way a surface runs
constexpr double kSameSurface_m = 0.3;     // between these; or
constexpr double kSameSurfaceShare = 0.5;  // of the range
constexpr std::size_t kLines = 5;          // on each side, those with most surface
constexpr double kSameYaw_rad = 0.035;
constexpr double kInside_m = 0.05;  // by which the robot is inside
constexpr double kSame_m = 0.1;     // between the sides of rectangles that count as the same

/// Metres of surface by where its line crosses one axis, from the robot.
using Surfaces = std::array<double, kBins>;

/// Lines on one side of the robot, by distance along an axis.
struct Lines {
  std::vector<double> below, above;
};

/// Surfaces across the x and the y axis of a frame turned by `yaw_rad`.
std::array<Surfaces, 2> surfaces(const Panorama& panorama, double yaw_rad) {
  std::array<Surfaces, 2> across{};
  const std::size_t count = panorama.sights.size();
  const auto end_of = [&](std::size_t i) {
    const Sight& s = panorama.sights[i % count];
    return rotate(-yaw_rad, s.range_m * s.direction);
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (!panorama.sights[i].meets) continue;
    const Point2 along = end_of(i + kNeighbour) - end_of(i + count - kNeighbour);
    const double length_m = along.norm();
    if (length_m > std::max(kSameSurface_m, kSameSurfaceShare * panorama.sights[i].range_m)) continue;
    for (const int axis : {0, 1}) {
      const double bin = std::floor((end_of(i)[axis] + kSurfaceReach_m) / kBin_m);
      if (std::abs(along[axis]) >= kAlong * length_m || bin < 0.0 || bin >= kBins) continue;
      across[static_cast<std::size_t>(axis)][static_cast<std::size_t>(bin)] += length_m / (2.0 * kNeighbour);
    }
  }
  return across;
}

/// Straight surfaces: where the sum over three bins is a maximum.
Lines lines_of(const Surfaces& surface) {
  Surfaces sums{};
  for (std::size_t i = 1; i + 1 < kBins; ++i) sums[i] = surface[i - 1] + surface[i] + surface[i + 1];
  std::vector<std::pair<double, double>> below, above;  // (surface, place)
  for (std::size_t i = kApart; i + kApart < kBins; ++i) {
    if (sums[i] < kLeastSurface_m) continue;
    const auto at = sums.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::max_element(at - kApart, at + kApart + 1) != at) continue;
    const double middle = (surface[i + 1] - surface[i - 1]) / sums[i];
    const double place_m = (static_cast<double>(i) + 0.5 + middle) * kBin_m - kSurfaceReach_m;
    (place_m < 0.0 ? below : above).emplace_back(sums[i], place_m);
  }
  const auto fullest = [](std::vector<std::pair<double, double>>& all) {
    std::sort(all.rbegin(), all.rend());
    std::vector<double> places;
    for (std::size_t i = 0; i < std::min(kLines, all.size()); ++i) places.push_back(all[i].second);
    return places;
  };
  return {fullest(below), fullest(above)};
}

/// Where one side begins and the other ends, for all pairs that keep within the limits and hold the robot.
std::vector<std::pair<double, double>> spans(const Lines& lines, const OutlineLimits& limits) {
  std::vector<std::pair<double, double>> all;
  for (const double from : lines.below)
    for (const double to : lines.above)
      if (from < -kInside_m && to > kInside_m && to - from >= limits.side_min_m &&
          to - from <= limits.side_max_m)
        all.emplace_back(from, to);
  return all;
}

/// Adds a line unless there is one already.
void add(std::vector<double>& places, double place_m) {
  const auto is_same = [&](double other) { return std::abs(other - place_m) < kSame_m; };
  if (std::none_of(places.begin(), places.end(), is_same)) places.push_back(place_m);
}

/// Rectangles turned like the seed.
std::vector<Rectangle> outlines_like(const Rectangle& seed, const std::vector<Rectangle>& seeds,
                                     const Panorama& panorama, const OutlineLimits& limits) {
  const auto across = surfaces(panorama, seed.yaw_rad);
  std::array<Lines, 2> lines{lines_of(across[0]), lines_of(across[1])};
  for (const Rectangle& other : seeds) {
    if (std::abs(other.yaw_rad - seed.yaw_rad) > kSameYaw_rad) continue;
    const Point2 centre = rotate(-seed.yaw_rad, Point2(other.x_m, other.y_m) - panorama.place);
    const Point2 half(0.5 * other.width_m, 0.5 * other.height_m);
    for (const int axis : {0, 1}) {
      add(lines[static_cast<std::size_t>(axis)].below, centre[axis] - half[axis]);
      add(lines[static_cast<std::size_t>(axis)].above, centre[axis] + half[axis]);
    }
  }
  std::vector<Rectangle> outlines;
  for (const auto& [x0, x1] : spans(lines[0], limits)) {
    for (const auto& [y0, y1] : spans(lines[1], limits)) {
      const Point2 centre = panorama.place + rotate(seed.yaw_rad, Point2(0.5 * (x0 + x1), 0.5 * (y0 + y1)));
      outlines.push_back({seed.yaw_rad, centre.x(), centre.y(), x1 - x0, y1 - y0});
    }
  }
  return outlines;
}

}  // namespace

std::optional<Rectangle> choose_outline(const std::vector<Rectangle>& seeds, const Panorama& panorama,
                                        const OutlineLimits& limits) {
  std::optional<Rectangle> best;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Rectangle& outline) {
    const double cost = implausibility(sight_of(outline, panorama));
    if (cost >= least) return;
    least = cost;
    best = outline;
  };
  for (const Rectangle& seed : seeds) offer(seed);
  std::vector<double> tried;
  for (const Rectangle& seed : seeds) {
    const auto is_same = [&](double yaw_rad) { return std::abs(yaw_rad - seed.yaw_rad) < kSameYaw_rad; };
    if (std::any_of(tried.begin(), tried.end(), is_same)) continue;
    tried.push_back(seed.yaw_rad);
    for (const Rectangle& outline : outlines_like(seed, seeds, panorama, limits)) offer(outline);
  }
  return best;
}

}  // namespace enfilade::room
