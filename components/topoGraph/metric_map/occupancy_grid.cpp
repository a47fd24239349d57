// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/metric_map/occupancy_grid.hpp"

#include <limits>
#include <stdexcept>
#include <string>
#include <unordered_map>

#include "components/topoGraph/metric_map/polygon_cells.hpp"

namespace enfilade::topo_graph {
namespace {

using Outline = std::vector<Point2>;

constexpr double kSqrt2 = std::numbers::sqrt2;
constexpr double kFinest_m = 0.005, kCoarsest_m = 5.0;  // resolution

Outline outline_of(const Room& room) {
  Outline outline;
  for (const Point2& p : room.polygon) outline.push_back(room.T_map_room * p);
  if (outline.size() >= 3) return outline;
  const auto corners = room.rectangle().corners();
  return {corners.begin(), corners.end()};
}

std::vector<const Room*> choose(const TopologicalMap& map, const std::vector<RoomId>& wanted) {
  std::vector<const Room*> rooms;
  for (const RoomId id : wanted) {
    const Room* room = map.find_room(id);
    if (!room) throw std::invalid_argument("there is no room " + std::to_string(id) + " in the map");
    rooms.push_back(room);
  }
  if (wanted.empty())
    for (const Room& room : map.rooms) rooms.push_back(&room);
  if (rooms.empty()) throw std::invalid_argument("the map holds no room yet");
  return rooms;
}

/// Both sides of a → b, `half` of the width on each, `longer` beyond its ends.
Outline strip(const Point2& a, const Point2& b, double half, double longer) {
  const Point2 along = b == a ? Point2(Point2::UnitX()) : Point2((b - a).normalized());
  const Point2 across = half * Point2(-along.y(), along.x());
  const Point2 from = a - longer * along, to = b + longer * along;
  return {from - across, to - across, to + across, from + across};
}

double drawn_wall_m(const MetricMapConfig& config) {
  return std::max(config.wall_m, kSqrt2 * config.resolution_m);
}

/// Which cells the rooms, their walls and the margin take.
struct Layout {
  Point2 first, size;  // in cells

  double cells() const { return size.x() * size.y(); }
};

Layout layout_of(const std::vector<Outline>& outlines, const MetricMapConfig& config) {
  Point2 low = Point2::Constant(1e300), high = Point2::Constant(-1e300);
  for (const Outline& outline : outlines)
    for (const Point2& p : outline) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double r = config.resolution_m, margin_m = drawn_wall_m(config) + std::max(config.margin_m, r);
  const Point2 first = ((low.array() - margin_m) / r).floor(), end = ((high.array() + margin_m) / r).ceil();
  return {first, end - first};
}

class MetricMapPainter {
 public:
  MetricMapPainter(const TopologicalMap& map, const MetricMapConfig& config)
      : map_(map), config_(config), rooms_(choose(map, config.rooms)) {
    const double r = config.resolution_m;
    if (!(r >= kFinest_m && r <= kCoarsest_m))
      throw std::invalid_argument("the resolution must lie in 0.005 … 5 m");
    wall_m_ = drawn_wall_m(config);
    for (std::size_t i = 0; i < rooms_.size(); ++i) {
      outlines_.push_back(outline_of(*rooms_[i]));
      number_of_[rooms_[i]->id] = static_cast<int>(i);
    }
    lay_out();
  }

  OccupancyGrid paint() {
    for (const Outline& outline : outlines_) paint_walls(outline);
    for (std::size_t i = 0; i < outlines_.size(); ++i) {
      for_cells(outlines_[i], [&](std::size_t cell) {
        grid_.cells[cell] = CellState::kFree;
        if (owner_[cell] < 0) owner_[cell] = static_cast<int>(i);
      });
    }
    part_rooms();
    for (const Door& door : map_.doors) paint_door(door);
    std::sort(grid_.doors.begin(), grid_.doors.end(),
              [](const DoorCell& a, const DoorCell& b) { return a.cell < b.cell; });
    return std::move(grid_);
  }

 private:
  void lay_out() {
    const Layout layout = layout_of(outlines_, config_);
    if (!(layout.cells() <= 268435456.0))
      throw std::invalid_argument("the map would have more than 2^28 cells; ask for a coarser resolution");
    grid_.resolution_m = config_.resolution_m;
    first_cell_ = layout.first;
    grid_.origin = grid_.resolution_m * layout.first;
    grid_.columns = static_cast<int>(layout.size.x());
    grid_.rows = static_cast<int>(layout.size.y());
    grid_.cells.assign(grid_.index(0, grid_.rows), CellState::kUnexplored);
    owner_.assign(grid_.cells.size(), -1);
  }

  template <class Visit>
  void for_cells(const Outline& outline, Visit&& visit) {
    Outline scaled = outline;
    for (Point2& p : scaled) p = p / grid_.resolution_m - first_cell_;
    for_cells_in(scaled, grid_.columns, grid_.rows,
                 [&](int column, int row) { visit(grid_.index(column, row)); });
  }

  void paint_walls(const Outline& outline) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Outline wall = strip(outline[i], outline[(i + 1) % outline.size()], wall_m_, wall_m_);
      for_cells(wall, [&](std::size_t cell) { grid_.cells[cell] = CellState::kOccupied; });
    }
  }

  /// A wall thinner than a cell must still part two rooms: the one counted later gives a cell for it.
  void part_rooms() {
    const auto part = [this](std::size_t a, std::size_t b) {
      if (owner_[a] < 0 || owner_[b] < 0 || owner_[a] == owner_[b]) return;
      const std::size_t given = owner_[a] > owner_[b] ? a : b;
      grid_.cells[given] = CellState::kOccupied;
    };
    for (int row = 0; row + 1 < grid_.rows; ++row) {
      for (int column = 0; column + 1 < grid_.columns; ++column) {
        const std::size_t here = grid_.index(column, row), above = grid_.index(column, row + 1);
        part(here, here + 1);
        part(here, above);
        part(here, above + 1);
        part(here + 1, above);
      }
    }
  }

  void paint_door(const Door& door) {
    if (door.kind == DoorKind::kBlocked || door.closed) return;
    const bool first = number_of_.count(door.face.room) > 0;
    const bool second = door.other_face && number_of_.count(door.other_face->room) > 0;
    if (first && second) {
      paint_passage(door);
    } else if (first) {
      paint_way_out(door, door.face);
    } else if (second) {
      paint_way_out(door, *door.other_face);
    }
  }

  struct Placed {
    Segment gap;
    Point2 inwards;
  };

  Placed placed(const DoorFace& face) const {
    const Room& room = *map_.find_room(face.room);
    return {segment_in_map(room, face), -room.rectangle().normal(face.gap.wall)};
  }

  /// From inside one room to inside the other: as far in as a wall may have been painted.
  void paint_passage(const Door& door) {
    const Placed a = placed(door.face), b = placed(*door.other_face);
    const double in_m = kSqrt2 * grid_.resolution_m;
    const Point2 into_a = in_m * a.inwards, into_b = in_m * b.inwards;
    // The walls of both rooms run counter-clockwise, so the one gap runs against the other.
    open(door, {a.gap.from, a.gap.to, b.gap.from, b.gap.to});
    open(door, {a.gap.from + into_a, a.gap.to + into_a, a.gap.to, a.gap.from});
    open(door, {b.gap.from + into_b, b.gap.to + into_b, b.gap.to, b.gap.from});
    open(door, strip(a.gap.midpoint() + into_a, b.gap.midpoint() + into_b, 0.5 * in_m, 0.5 * in_m));
  }

  void paint_way_out(const Door& door, const DoorFace& face) {
    const Placed a = placed(face);
    const double in_m = kSqrt2 * grid_.resolution_m;
    const Point2 in = in_m * a.inwards, out = -wall_m_ * a.inwards;
    open(door, {a.gap.from + in, a.gap.to + in, a.gap.to + out, a.gap.from + out});
    open(door, strip(a.gap.midpoint() + in, a.gap.midpoint() + out, 0.5 * in_m, 0.0));
  }

  void open(const Door& door, const Outline& outline) {
    for_cells(outline, [&](std::size_t cell) {
      if (grid_.cells[cell] == CellState::kFree) return;
      grid_.cells[cell] = CellState::kFree;
      grid_.doors.push_back({cell, door.height_m.value_or(config_.lintel_m)});
    });
  }

  const TopologicalMap& map_;
  const MetricMapConfig& config_;
  std::vector<const Room*> rooms_;
  std::vector<Outline> outlines_;
  std::unordered_map<RoomId, int> number_of_;
  double wall_m_ = 0.0;
  Point2 first_cell_ = Point2::Zero();
  OccupancyGrid grid_;
  std::vector<int> owner_;  ///< number of the room a cell lies in, -1 = none
};

}  // namespace

CellState OccupancyGrid::at(const Point2& p) const {
  const Point2 cell = ((p - origin) / resolution_m).array().floor();
  const bool inside = cell.x() >= 0 && cell.y() >= 0 && cell.x() < columns && cell.y() < rows;
  return inside ? at(static_cast<int>(cell.x()), static_cast<int>(cell.y())) : CellState::kUnexplored;
}

double resolution_within(const TopologicalMap& map, MetricMapConfig config, std::size_t most_cells) {
  std::vector<Outline> outlines;
  for (const Room* room : choose(map, config.rooms)) outlines.push_back(outline_of(*room));
  while (config.resolution_m < kCoarsest_m &&
         !(layout_of(outlines, config).cells() <= static_cast<double>(most_cells)))
    config.resolution_m *= 2.0;
  return config.resolution_m;
}

OccupancyGrid draw_metric_map(const TopologicalMap& map, const MetricMapConfig& config) {
  return MetricMapPainter(map, config).paint();
}

}  // namespace enfilade::topo_graph
