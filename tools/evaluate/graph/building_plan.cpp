// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/graph/building_plan.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace enfilade::evaluate {
namespace {

constexpr double kPitchX = 4.4, kPitchY = 4.0, kCorridorY = 2.4;

using Place = std::pair<int, int>;  // column, row

/// Cells by place, in the order of driving, with the passages between neighbours.
class PlanBuilder {
 public:
  std::size_t add(Place place, const Cell& cell) {
    index_[place] = plan_.cells.size();
    plan_.cells.push_back(cell);
    return index_[place];
  }
  void drive(Place from, Place to) {
    driven_[std::minmax(from, to)] = true;
    plan_.driven.push_back(passage(from, to));
  }
  /// Neighbours that nobody drove between, in the order of the cells.
  void add_undriven(bool rows_too) {
    std::vector<Place> places(plan_.cells.size());
    for (const auto& [place, cell] : index_) places[cell] = place;
    for (const Place& place : places) {
      const auto [column, row] = place;
      add_if_undriven(place, {column + 1, row});
      if (rows_too) add_if_undriven(place, {column, row + 1});
    }
  }
  BuildingPlan take() { return std::move(plan_); }

 private:
  void add_if_undriven(Place from, Place to) {
    if (index_.count(to) && !driven_.count(std::minmax(from, to))) plan_.loops.push_back(passage(from, to));
  }
  Passage passage(Place from, Place to) const {
    const int wall = to.first > from.first ? 0 : to.second > from.second ? 1 : to.first < from.first ? 2 : 3;
    return {index_.at(from), index_.at(to), wall};
  }

  BuildingPlan plan_;
  std::map<Place, std::size_t> index_;
  std::map<std::pair<Place, Place>, bool> driven_;
};

Cell cell_at(Place place) { return {kPitchX * place.first, kPitchY * place.second, kPitchX, kPitchY}; }

void drive_along(PlanBuilder& builder, const std::vector<Place>& places) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    builder.add(places[i], cell_at(places[i]));
    if (i > 0) builder.drive(places[i - 1], places[i]);
  }
}

BuildingPlan grid(int rooms) {
  const int columns = std::max(2, static_cast<int>(std::sqrt(rooms)));
  std::vector<Place> places;
  for (int i = 0; i < rooms; ++i) {
    const int row = i / columns, along = i % columns;
    places.emplace_back(row % 2 == 0 ? along : columns - 1 - along, row);
  }
  PlanBuilder builder;
  drive_along(builder, places);
  builder.add_undriven(true);
  return builder.take();
}

BuildingPlan ring(int rooms) {
  const int columns = std::max(2, (rooms + 4) / 4), rows = std::max(2, (rooms + 4) / 2 - columns);
  std::vector<Place> places;
  for (int i = 0; i < columns; ++i) places.emplace_back(i, 0);
  for (int i = 1; i < rows; ++i) places.emplace_back(columns - 1, i);
  for (int i = columns - 2; i >= 0; --i) places.emplace_back(i, rows - 1);
  for (int i = rows - 2; i >= 1; --i) places.emplace_back(0, i);
  PlanBuilder builder;
  drive_along(builder, places);
  builder.add_undriven(true);
  return builder.take();
}

BuildingPlan corridor(int rooms) {
  PlanBuilder builder;
  const double aside_m = 0.5 * (kPitchY + kCorridorY);
  for (int column = 0; column < std::max(1, rooms / 3); ++column) {
    const double x_m = kPitchX * column;
    builder.add({column, 0}, {x_m, 0.0, kPitchX, kCorridorY});
    if (column > 0) builder.drive({column - 1, 0}, {column, 0});
    for (const int side : {1, -1}) {
      builder.add({column, side}, {x_m, side * aside_m, kPitchX, kPitchY});
      builder.drive({column, 0}, {column, side});
    }
  }
  builder.add_undriven(false);
  return builder.take();
}

}  // namespace

BuildingPlan make_plan(const SyntheticSpec& spec, std::mt19937_64& random) {
  BuildingPlan plan = spec.building == Building::kGrid   ? grid(spec.rooms)
                      : spec.building == Building::kRing ? ring(spec.rooms)
                                                         : corridor(spec.rooms);
  for (std::size_t i = plan.loops.size(); i > 1; --i) std::swap(plan.loops[i - 1], plan.loops[random() % i]);
  plan.loops.resize(std::min(plan.loops.size(), static_cast<std::size_t>(std::max(0, spec.loops))));
  return plan;
}

}  // namespace enfilade::evaluate
