// SPDX-License-Identifier: Apache-2.0
#include "tools/room/panorama.hpp"

#include <algorithm>
#include <cmath>

#include "components/roomDetector/core/column_index.hpp"

namespace enfilade::room {
namespace {

constexpr int kSights = 720;
constexpr double kFarthest_m = 16.0;
constexpr double kOwnPlace_m = 0.3;  // the robot's own place may not have been seen
constexpr int kBridgedCells = 2;     // cells that no measurement happened to pass

CellState state_at(const room_detector::ColumnIndex& states, const Point2& p) {
  const auto state = states.find(static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y())));
  return state == room_detector::ColumnIndex::kNone ? CellState::kUnexplored : static_cast<CellState>(state);
}

/// Where a sight enters a cell.
double range_of_face(const Point2& place, const Point2& direction, const Point2& cell, double resolution_m) {
  double range_m = 0.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double face = cell[axis] + (direction[axis] > 0.0 ? 0.0 : 1.0);
    if (std::abs(direction[axis]) > 1e-9)
      range_m = std::max(range_m, (face * resolution_m - place[axis]) / direction[axis]);
  }
  return range_m;
}

/// In steps of half a cell.
Sight look(const room_detector::ColumnIndex& states, const Point2& place, double resolution_m,
           double angle_rad) {
  Sight sight{.direction = {std::cos(angle_rad), std::sin(angle_rad)}};
  int unknown = 0;
  for (double range_m = 0.0; range_m < kFarthest_m; range_m += 0.5 * resolution_m) {
    const Point2 at = (place + range_m * sight.direction) / resolution_m;
    const CellState state = state_at(states, at);
    if (state == CellState::kOccupied) {
      const Point2 cell(std::floor(at.x()), std::floor(at.y()));
      return {sight.direction, range_of_face(place, sight.direction, cell, resolution_m), true};
    }
    unknown = state == CellState::kFree ? 0 : unknown + 1;
    if (unknown == 0) sight.range_m = range_m;
    if (unknown > 2 * kBridgedCells && range_m > kOwnPlace_m) break;
  }
  return sight;
}

}  // namespace

Panorama look_around(const Survey& view, const Point2& place) {
  room_detector::ColumnIndex states;
  const int layer = planar_layer(view.resolution_m);
  for (const GridCell& cell : view.cells)
    if (cell.z == layer) states.at(cell.x, cell.y) = static_cast<std::int32_t>(cell.state);
  Panorama panorama{.place = place, .resolution_m = view.resolution_m};
  for (int i = 0; i < kSights; ++i)
    panorama.sights.push_back(look(states, place, view.resolution_m, 2.0 * kPi * i / kSights));
  return panorama;
}

}  // namespace enfilade::room
