// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "interfaces/geometry/pose2.hpp"

namespace enfilade::topo_graph {

/// Calls visit(column, row) for each cell, within columns × rows, whose centre lies in the polygon (even-odd
/// rule). The polygon's coordinates are in cells.
template <class Visit>
void for_cells_in(const std::vector<Point2>& polygon, int columns, int rows, Visit&& visit) {
  double low = 1e300, high = -1e300;
  for (const Point2& p : polygon) low = std::min(low, p.y()), high = std::max(high, p.y());
  const int first = static_cast<int>(std::clamp(std::ceil(low - 0.5), 0.0, static_cast<double>(rows)));
  const int end = static_cast<int>(std::clamp(std::ceil(high - 0.5), 0.0, static_cast<double>(rows)));
  std::vector<double> crossings;
  for (int row = first; row < end; ++row) {
    const double y = row + 0.5;
    crossings.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point2& a = polygon[i];
      const Point2& b = polygon[(i + 1) % polygon.size()];
      if ((a.y() <= y) != (b.y() <= y))
        crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const auto column_of = [columns](double x) {
        return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(columns)));
      };
      const int stop = column_of(crossings[i + 1]);
      for (int column = column_of(crossings[i]); column < stop; ++column) visit(column, row);
    }
  }
}

}  // namespace enfilade::topo_graph
