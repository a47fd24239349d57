// SPDX-License-Identifier: Apache-2.0
#include "tools/room/panorama.hpp"

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

/// In steps of half a cell.
Sight look(const room_detector::ColumnIndex& states, const Point2& place, double resolution_m,
           double angle_rad) {
  Sight sight{.direction = {std::cos(angle_rad), std::sin(angle_rad)}};
  int unknown = 0;
  for (double range_m = 0.0; range_m < kFarthest_m; range_m += 0.5 * resolution_m) {
    const CellState state = state_at(states, (place + range_m * sight.direction) / resolution_m);
    if (state == CellState::kOccupied) return {sight.direction, range_m, true};
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
