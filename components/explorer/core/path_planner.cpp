// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/path_planner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

namespace enfilade::explorer {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr std::array<CellXY, 8> kNeighbours{
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

}  // namespace

Reach::Reach(const FloorMap& map, const PathPlannerConfig& config, const Point2& start)
    : map_(map), config_(config), start_(start) {
  const auto cells = static_cast<std::size_t>(map.width()) * static_cast<std::size_t>(map.height());
  cost_.assign(cells, kInfinite);
  parent_.assign(cells, -1);
  if (!map.contains(map.cell_at(start))) return;
  start_clearance_m_ = map.to_obstacle_m(map.cell_at(start));
  spread();
}

/// Cost of a metre in this cell; infinite where the robot must not be.
double Reach::step_cost(CellXY c) const {
  if (map_.floor(c) == Floor::kObstacle) return kInfinite;
  const double clearance_m = map_.to_obstacle_m(c);
  const bool allowed =
      clearance_m >= config_.hard_radius_m && map_.to_unexplored_m(c) >= config_.unexplored_radius_m;
  const double soft = std::clamp(
      (config_.soft_radius_m - clearance_m) / (config_.soft_radius_m - config_.hard_radius_m), 0.0, 2.0);
  const double cost = 1.0 + config_.soft_cost * soft * soft;
  if (allowed) return cost;
  const bool escaping = (map_.centre(c) - start_).norm() <= config_.escape_m &&
                        clearance_m >= std::min(start_clearance_m_, config_.hard_radius_m) - 0.01 &&
                        map_.floor(c) == Floor::kFree;
  return escaping ? 5.0 * cost : kInfinite;
}

void Reach::spread() {
  using Entry = std::pair<float, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const std::size_t from = map_.index(map_.cell_at(start_));
  cost_[from] = 0.0F;
  open.emplace(0.0F, static_cast<std::int32_t>(from));
  while (!open.empty()) {
    const auto [cost, i] = open.top();
    open.pop();
    if (cost > cost_[static_cast<std::size_t>(i)]) continue;
    const CellXY c = map_.cell(static_cast<std::size_t>(i));
    for (const CellXY& d : kNeighbours) {
      const CellXY next{c.x + d.x, c.y + d.y};
      if (!map_.contains(next)) continue;
      const double length_m = map_.resolution_m() * (d.x != 0 && d.y != 0 ? std::sqrt(2.0) : 1.0);
      const float total = cost + static_cast<float>(length_m * step_cost(next));
      const std::size_t j = map_.index(next);
      if (total >= cost_[j]) continue;
      cost_[j] = total;
      parent_[j] = i;
      open.emplace(total, static_cast<std::int32_t>(j));
    }
  }
}

bool Reach::reaches(CellXY c) const { return map_.contains(c) && std::isfinite(cost_[map_.index(c)]); }

double Reach::cost_m(CellXY c) const {
  return map_.contains(c) ? static_cast<double>(cost_[map_.index(c)]) : static_cast<double>(kInfinite);
}

std::optional<Path> Reach::path_to(const Point2& goal) const {
  if (!reaches(map_.cell_at(goal))) return std::nullopt;
  std::vector<Point2> points{goal};
  for (auto i = parent_[map_.index(map_.cell_at(goal))]; i >= 0; i = parent_[static_cast<std::size_t>(i)]) {
    points.push_back(map_.centre(map_.cell(static_cast<std::size_t>(i))));
  }
  if (points.size() == 1) points.push_back(start_);
  points.back() = start_;
  std::reverse(points.begin(), points.end());
  Path path{.points = straightened(points)};
  for (std::size_t i = 1; i < path.points.size(); ++i)
    path.length_m += (path.points[i] - path.points[i - 1]).norm();
  return path;
}

std::optional<Point2> Reach::nearest(const Point2& p, double within_m) const {
  std::optional<Point2> best;
  double best_m = within_m;
  const CellXY middle = map_.cell_at(p);
  if (reaches(middle)) return p;
  const int reach = static_cast<int>(std::ceil(within_m / map_.resolution_m()));
  for (int y = middle.y - reach; y <= middle.y + reach; ++y) {
    for (int x = middle.x - reach; x <= middle.x + reach; ++x) {
      const double distance_m = (map_.centre({x, y}) - p).norm();
      if (!reaches({x, y}) || distance_m >= best_m) continue;
      best_m = distance_m;
      best = map_.centre({x, y});
    }
  }
  return best;
}

/// Least distance to an obstacle along the segment; 0 where it leaves the cells the robot may be in.
double Reach::clearance_m(const Point2& a, const Point2& b) const {
  const int steps = std::max(1, static_cast<int>(std::ceil((b - a).norm() / (0.5 * map_.resolution_m()))));
  double least_m = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    const CellXY c = map_.cell_at(a + (b - a) * (static_cast<double>(i) / steps));
    if (!std::isfinite(step_cost(c))) return 0.0;
    least_m = std::min(least_m, map_.to_obstacle_m(c));
  }
  return least_m;
}

std::vector<Point2> Reach::straightened(const std::vector<Point2>& points) const {
  std::vector<Point2> corners{points.front()};
  for (std::size_t from = 0; from + 1 < points.size();) {
    double along_m = map_.to_obstacle_m(map_.cell_at(points[from]));
    std::size_t last = from + 1;
    for (std::size_t to = from + 1; to < points.size(); ++to) {
      along_m = std::min(along_m, map_.to_obstacle_m(map_.cell_at(points[to])));
      const double wanted_m = std::min(config_.soft_radius_m, along_m) - 0.5 * map_.resolution_m();
      if (clearance_m(points[from], points[to]) >= wanted_m) last = to;
    }
    corners.push_back(points[last]);
    from = last;
  }
  drop_short_legs(corners);
  return corners;
}

/// A leg of a few cells costs two turns on the spot; where the robot may cut the corner, it does.
void Reach::drop_short_legs(std::vector<Point2>& corners) const {
  const double short_m = 3.0 * map_.resolution_m();
  for (std::size_t i = 1; i + 1 < corners.size();) {
    const bool is_short =
        (corners[i + 1] - corners[i]).norm() < short_m || (corners[i] - corners[i - 1]).norm() < short_m;
    if (is_short && clearance_m(corners[i - 1], corners[i + 1]) >= config_.hard_radius_m) {
      corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
}

}  // namespace enfilade::explorer
