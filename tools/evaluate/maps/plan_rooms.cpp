// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/maps/plan_rooms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace enfilade::evaluate {
namespace {

using simulator::GreyImage;

constexpr int kWhite = 250;
constexpr double kLeastArea_m2 = 2.0;
constexpr double kClearance_m = 0.3;
constexpr std::size_t kStands = 3;

bool is_white(const GreyImage& image, std::size_t i) { return image.pixels[i] >= kWhite; }

/// Pixels of each white area, joined by their sides.
std::vector<std::vector<int>> white_areas(const GreyImage& image) {
  std::vector<bool> seen(image.pixels.size(), false);
  std::vector<std::vector<int>> areas;
  for (std::size_t first = 0; first < image.pixels.size(); ++first) {
    if (seen[first] || !is_white(image, first)) continue;
    std::vector<int> area{static_cast<int>(first)};
    seen[first] = true;
    for (std::size_t k = 0; k < area.size(); ++k) {
      const int i = area[k], column = i % image.columns;
      const auto visit = [&](int next, bool exists) {
        if (!exists || seen[static_cast<std::size_t>(next)] ||
            !is_white(image, static_cast<std::size_t>(next)))
          return;
        seen[static_cast<std::size_t>(next)] = true;
        area.push_back(next);
      };
      visit(i - 1, column > 0);
      visit(i + 1, column + 1 < image.columns);
      visit(i - image.columns, i >= image.columns);
      visit(i + image.columns, i + image.columns < image.columns * image.rows);
    }
    areas.push_back(std::move(area));
  }
  return areas;
}

/// Pixels to the nearest one that is not white, diagonal steps counting one.
std::vector<int> clearances(const GreyImage& image) {
  std::vector<int> clear(image.pixels.size(), 0);
  const auto at = [&](int row, int column) {
    const bool exists = row >= 0 && column >= 0 && row < image.rows && column < image.columns;
    return exists ? clear[static_cast<std::size_t>(row * image.columns + column)] : 0;
  };
  const auto pass = [&](int row, int column, int back) {
    const auto i = static_cast<std::size_t>(row * image.columns + column);
    if (!is_white(image, i)) return;
    const int nearest = std::min(std::min(at(row + back, column - 1), at(row + back, column)),
                                 std::min(at(row + back, column + 1), at(row, column + back)));
    clear[i] = back < 0 ? nearest + 1 : std::min(clear[i], nearest + 1);
  };
  for (int row = 0; row < image.rows; ++row)
    for (int column = 0; column < image.columns; ++column) pass(row, column, -1);
  for (int row = image.rows - 1; row >= 0; --row)
    for (int column = image.columns - 1; column >= 0; --column) pass(row, column, +1);
  return clear;
}

double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Convex hull, counter-clockwise.
std::vector<Point2> hull_of(std::vector<Point2> points) {
  const auto before = [](const Point2& a, const Point2& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  };
  std::sort(points.begin(), points.end(), before);
  std::vector<Point2> hull;
  for (const bool upper : {false, true}) {
    const std::size_t base = hull.size();
    for (const Point2& p : points) {
      while (hull.size() >= base + 2 && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    if (!upper) std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// The pixel's centre, in metres from the lower left corner.
Point2 centre_of(int pixel, const GreyImage& image, double resolution_m) {
  const int row = pixel / image.columns, column = pixel % image.columns;
  return resolution_m * Point2(column + 0.5, image.rows - row - 0.5);
}

/// Not in a doorway: who stands there is in both rooms.
std::vector<Point2> stands_in(const Rectangle& room, const std::vector<int>& area, const GreyImage& plan,
                              const std::vector<int>& clear, double resolution_m) {
  std::vector<Point2> stands;
  while (stands.size() < kStands) {
    double best = 0.0;
    int chosen = -1;
    for (const int pixel : area) {
      const int clearance = clear[static_cast<std::size_t>(pixel)];
      const Point2 place = centre_of(pixel, plan, resolution_m);
      if (clearance * resolution_m < kClearance_m || !room.contains(place, kClearance_m)) continue;
      double value = stands.empty() ? clearance : std::numeric_limits<double>::infinity();
      for (const Point2& stand : stands) value = std::min(value, (place - stand).norm());
      if (value <= best) continue;
      best = value;
      chosen = pixel;
    }
    if (chosen < 0) break;
    stands.push_back(centre_of(chosen, plan, resolution_m));
  }
  return stands;
}

/// The stretch of an axis where the points fill at least half of `across_m`; they stand for `cell_m` each
/// way.
std::pair<double, double> filled_stretch(const std::vector<double>& along, double across_m, double cell_m) {
  const auto [low, high] = std::minmax_element(along.begin(), along.end());
  const auto bin = [&](double a) { return static_cast<std::size_t>(std::lround((a - *low) / cell_m)); };
  std::vector<double> filled(bin(*high) + 1, 0.0);
  for (const double a : along) filled[bin(a)] += cell_m;
  std::size_t first = 0, last = filled.size();
  while (first + 1 < last && filled[first] < 0.5 * across_m) ++first;
  while (last > first + 1 && filled[last - 1] < 0.5 * across_m) --last;
  return {*low + (static_cast<double>(first) - 0.5) * cell_m,
          *low + (static_cast<double>(last) - 0.5) * cell_m};
}

/// `r` without the strips along its sides that the cells fill by less than half.
Rectangle without_niches(const Rectangle& r, const std::vector<Point2>& cells, double cell_m) {
  std::vector<double> x, y;
  for (const Point2& cell : cells) {
    const Point2 q = r.pose().inverse() * cell;
    x.push_back(q.x());
    y.push_back(q.y());
  }
  const auto [x0, x1] = filled_stretch(x, r.height_m, cell_m);
  const auto [y0, y1] = filled_stretch(y, r.width_m, cell_m);
  const Point2 centre = r.pose() * Point2(0.5 * (x0 + x1), 0.5 * (y0 + y1));
  return {r.yaw_rad, centre.x(), centre.y(), x1 - x0, y1 - y0};
}

/// Of cells and a rectangle.
double iou_of(const std::vector<Point2>& cells, const Rectangle& r, double cell_m) {
  const double cell_m2 = cell_m * cell_m, all = static_cast<double>(cells.size()) * cell_m2;
  double inside = 0.0;
  for (const Point2& cell : cells) inside += r.contains(cell) ? cell_m2 : 0.0;
  return inside / (r.area_m2() + all - inside);
}

}  // namespace

Rectangle smallest_rectangle(std::vector<Point2> points) {
  const std::vector<Point2> hull = points.size() < 3 ? std::vector<Point2>{} : hull_of(std::move(points));
  Rectangle best;
  for (std::size_t i = 0; i < hull.size(); ++i) {  // one of its sides lies on a side of the hull
    const Point2 side = hull[(i + 1) % hull.size()] - hull[i];
    const double yaw = std::atan2(side.y(), side.x());
    Point2 low = Point2::Constant(1e9), high = -low;
    for (const Point2& p : hull) {
      const Point2 q = rotate(-yaw, p);
      low = low.cwiseMin(q);
      high = high.cwiseMax(q);
    }
    const Point2 size = high - low, centre = rotate(yaw, 0.5 * (low + high));
    const Rectangle r{yaw, centre.x(), centre.y(), size.x(), size.y()};
    if (i == 0 || r.area_m2() < best.area_m2()) best = r;
  }
  return canonical(best).rectangle;
}

std::vector<PlanRoom> plan_rooms(const GreyImage& segmentation, const GreyImage& plan, double resolution_m) {
  if (segmentation.columns != plan.columns || segmentation.rows != plan.rows)
    throw std::invalid_argument("plan and rooms are images of different sizes");
  const std::vector<int> clear = clearances(plan);
  std::vector<PlanRoom> rooms;
  for (const std::vector<int>& area : white_areas(segmentation)) {
    const double area_m2 = static_cast<double>(area.size()) * resolution_m * resolution_m;
    if (area_m2 < kLeastArea_m2) continue;
    std::vector<Point2> corners, cells;
    for (const int pixel : area) {
      cells.push_back(centre_of(pixel, segmentation, resolution_m));
      for (const Point2& half : {Point2(-0.5, -0.5), Point2(0.5, -0.5), Point2(0.5, 0.5), Point2(-0.5, 0.5)})
        corners.push_back(cells.back() + resolution_m * half);
    }
    const Rectangle r = without_niches(smallest_rectangle(std::move(corners)), cells, resolution_m);
    rooms.push_back({r, iou_of(cells, r, resolution_m), stands_in(r, area, plan, clear, resolution_m)});
  }
  return rooms;
}

}  // namespace enfilade::evaluate
