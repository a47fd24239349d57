// SPDX-License-Identifier: Apache-2.0
#include <queue>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <octomap/octomap.h>

#include "components/topoGraph/exports/exports.hpp"
#include "components/topoGraph/merge/map_merge.hpp"
#include "components/topoGraph/metric_map/map_formats.hpp"
#include "components/topoGraph/routes/map_check.hpp"
#include "components/topoGraph/routes/route.hpp"
#include "tests/unit/components/topoGraph/rooms.hpp"

namespace enfilade::topo_graph {
namespace {

using namespace test;

/// Rooms 1 and 2 of rooms.hpp joined by door 1; turned and shifted by `T_map_rooms`.
TopologicalMap two_rooms(const Pose2& T_map_rooms = {}) {
  TopologicalMap map;
  for (const Rectangle& r : {room1(), room2()}) {
    Room room;
    room.id = static_cast<RoomId>(map.rooms.size() + 1);
    room.name = "room " + std::to_string(room.id);
    room.T_map_room = T_map_rooms * r.pose();
    room.width_m = r.width_m;
    room.height_m = r.height_m;
    map.rooms.push_back(room);
  }
  map.doors = {{.id = 1,
                .kind = DoorKind::kPassage,
                .face = {1, door_from_room1().gap},
                .other_face = DoorFace{2, door_from_room2().gap},
                .height_m = 1.9}};
  return map;
}

/// A row of `count` rooms of 4 × 4 m, walls 0.15 m thick, each with a door to the next one.
TopologicalMap row_of_rooms(int count) {
  TopologicalMap map;
  for (int i = 0; i < count; ++i) {
    Room room;
    room.id = static_cast<RoomId>(i + 1);
    room.T_map_room = {4.15 * i, 0.0, 0.0};
    room.width_m = room.height_m = 4.0;
    map.rooms.push_back(room);
    const auto id = static_cast<DoorId>(i + 1);
    if (i + 1 < count)
      map.doors.push_back({.id = id,
                           .kind = DoorKind::kPassage,
                           .face = {id, {0, 1.0, 2.0}},
                           .other_face = DoorFace{id + 1, {2, 2.0, 3.0}}});
  }
  return map;
}

/// Whether free cells, side by side, lead from a to b.
bool leads(const OccupancyGrid& grid, const Point2& a, const Point2& b) {
  const auto cell_of = [&grid](const Point2& p) {
    const Point2 c = ((p - grid.origin) / grid.resolution_m).array().floor();
    return grid.index(static_cast<int>(c.x()), static_cast<int>(c.y()));
  };
  std::vector<bool> seen(grid.cells.size());
  std::queue<std::size_t> todo;
  const auto visit = [&](std::size_t cell) {
    if (seen[cell] || grid.cells[cell] != CellState::kFree) return;
    seen[cell] = true;
    todo.push(cell);
  };
  const auto columns = static_cast<std::size_t>(grid.columns);
  for (visit(cell_of(a)); !todo.empty(); todo.pop())
    for (const std::size_t next :
         {todo.front() - 1, todo.front() + 1, todo.front() - columns, todo.front() + columns})
      visit(next);
  return seen[cell_of(b)];
}

TEST(MetricMap, HasFreeRoomsInsideOccupiedWallsWithAnOpenDoor) {
  const OccupancyGrid grid = draw_metric_map(two_rooms(), {});
  EXPECT_EQ(grid.at({0.0, 0.0}), CellState::kFree);
  EXPECT_EQ(grid.at({1.57, -1.0}), CellState::kFree);
  EXPECT_EQ(grid.at({1.63, -1.0}), CellState::kOccupied);
  EXPECT_EQ(grid.at({1.67, -1.0}), CellState::kOccupied);
  EXPECT_EQ(grid.at({1.67, 0.5}), CellState::kFree);
  EXPECT_EQ(grid.at({0.0, 1.93}), CellState::kOccupied);
  EXPECT_EQ(grid.at({0.0, 2.07}), CellState::kUnexplored);
  EXPECT_EQ(grid.at({50.0, 0.0}), CellState::kUnexplored);
}

TEST(MetricMap, JoinsRoomsByTheirDoorsAloneAtAnyResolutionAndAngle) {
  for (const double resolution_m : {0.02, 0.05, 0.1, 0.13, 0.25, 0.4}) {
    for (const double yaw : {0.0, 0.3, 0.785, 1.2}) {
      const Pose2 T{0.37, -5.11, yaw};
      TopologicalMap map = two_rooms(T);
      const Point2 a = T * room1().pose().translation(), b = T * room2().pose().translation();
      const auto joined = [&] { return leads(draw_metric_map(map, {.resolution_m = resolution_m}), a, b); };
      EXPECT_TRUE(joined()) << resolution_m << " m, " << yaw;
      map.doors[0].kind = DoorKind::kBlocked;
      EXPECT_FALSE(joined()) << resolution_m << " m, " << yaw;
      map.doors[0].kind = DoorKind::kPassage;
      map.doors[0].closed = true;
      EXPECT_FALSE(joined()) << resolution_m << " m, " << yaw;
    }
  }
}

TEST(MetricMap, HoldsOnlyTheRoomsAskedFor) {
  const OccupancyGrid grid = draw_metric_map(two_rooms(), {.rooms = {2}});
  EXPECT_EQ(grid.at(room2().pose().translation()), CellState::kFree);
  EXPECT_EQ(grid.at({0.0, 0.0}), CellState::kUnexplored);
  EXPECT_THROW(draw_metric_map(two_rooms(), {.rooms = {3}}), std::invalid_argument);
  EXPECT_THROW(draw_metric_map(two_rooms(), {.resolution_m = 0.0}), std::invalid_argument);
  EXPECT_THROW(draw_metric_map({}, {}), std::invalid_argument);
}

TEST(OctoMapFile, HoldsForOctoMapWhatTheGridHoldsUpToTheLintels) {
  const TopologicalMap map = two_rooms({0.3, -2.0, 0.4});
  const OccupancyGrid grid = draw_metric_map(map, {.resolution_m = 0.1});
  std::istringstream file(to_octomap(grid));
  octomap::OcTree tree(0.1);
  ASSERT_TRUE(tree.readBinary(file));
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const Point2 p = grid.origin + 0.1 * Point2(column + 0.5, row + 0.5);
      const bool door = std::any_of(grid.doors.begin(), grid.doors.end(),
                                    [&](const DoorCell& d) { return d.cell == grid.index(column, row); });
      for (const double z : {0.05, 1.85, 1.95, 2.45}) {
        const auto* node = tree.search(p.x(), p.y(), z);
        const CellState state = door && z > 1.9 ? CellState::kOccupied : grid.at(column, row);
        ASSERT_EQ(node != nullptr, state != CellState::kUnexplored);
        if (node) {
          ASSERT_EQ(tree.isNodeOccupied(node), state == CellState::kOccupied);
        }
      }
      ASSERT_EQ(tree.search(p.x(), p.y(), -0.05), nullptr);
      ASSERT_EQ(tree.search(p.x(), p.y(), 2.55), nullptr);
    }
  }
}

TEST(GeoJson, HoldsClosedPolygonsAndDoors) {
  const auto json = nlohmann::json::parse(to_geojson(two_rooms()));
  ASSERT_EQ(json["features"].size(), 3u);
  const auto& ring = json["features"][0]["geometry"]["coordinates"][0];
  EXPECT_EQ(ring.size(), 5u);
  EXPECT_EQ(ring.front(), ring.back());
  EXPECT_EQ(json["features"][2]["geometry"]["coordinates"][0], nlohmann::json({1.6, 0.55}));
}

TEST(PartOfAMap, LeavesNoDoorToARoomThatIsNotInIt) {
  const TopologicalMap part = part_of(two_rooms(), {2});
  ASSERT_EQ(part.rooms.size(), 1u);
  ASSERT_EQ(part.doors.size(), 1u);
  EXPECT_EQ(part.doors[0].kind, DoorKind::kUnresolved);
  EXPECT_EQ(part.doors[0].face.room, 2u);
  EXPECT_FALSE(part.doors[0].other_face);
}

TEST(Route, GoesStraightFromDoorToDoor) {
  const TopologicalMap map = row_of_rooms(4);
  const auto route = find_route(map, {1, {0.0, -0.5}}, {4, {12.45, -0.5}});
  ASSERT_TRUE(route);
  EXPECT_NEAR(route->length_m, 12.45, 1e-9);
  ASSERT_EQ(route->legs.size(), 4u);
  EXPECT_EQ(route->legs[1].door, DoorId{2});
  EXPECT_NEAR((route->legs[1].enter - Point2(2.15, -0.5)).norm(), 0.0, 1e-9);
  EXPECT_FALSE(route->legs[3].door);
}

TEST(Route, GoesRoundAClosedDoorOrNotAtAll) {
  TopologicalMap map = row_of_rooms(3);
  map.doors.push_back({.id = 9,
                       .kind = DoorKind::kPassage,
                       .face = {1, {0, 2.5, 3.5}},
                       .other_face = DoorFace{2, {2, 0.5, 1.5}}});
  const RoutePlace from = middle_of(map.rooms[0]), to = middle_of(map.rooms[2]);
  EXPECT_EQ(find_route(map, from, to)->legs[0].door, DoorId{1});
  const auto round = find_route(map, from, to, {1});
  ASSERT_TRUE(round);
  EXPECT_EQ(round->legs[0].door, DoorId{9});
  EXPECT_GT(round->length_m, find_route(map, from, to)->length_m);
  EXPECT_FALSE(find_route(map, from, to, {2}));
  map.doors[0].closed = true;
  EXPECT_EQ(find_route(map, from, to), round);
  EXPECT_NEAR(find_route(map, from, {1, {1.0, 0.0}})->length_m, 1.0, 1e-12);
}

/// Rooms of different sizes in a row, told apart by them; from the room before `first` on, seen from a frame
/// of their own that is turned by a quarter, with ids from 1.
TopologicalMap row_of_different_rooms() {
  TopologicalMap map = row_of_rooms(5);
  for (Room& room : map.rooms) {
    room.height_m = 4.0 + 0.5 * (room.id % 3);
    room.name = "room " + std::to_string(room.id);
  }
  for (Door& door : map.doors) door.face.gap = {0, 1.0, 2.0}, door.other_face->gap = {2, 2.0, 3.0};
  for (Door& door : map.doors) {
    const double height_m = map.find_room(door.other_face->room)->height_m;
    const double up_m = 0.5 * (height_m - map.find_room(door.face.room)->height_m);
    door.other_face->gap = {2, height_m - 2.0 - up_m, height_m - 1.0 - up_m};
  }
  return map;
}

TopologicalMap renumbered(TopologicalMap map, RoomId less, const Pose2& T) {
  for (Room& room : map.rooms) {
    room.id -= less;
    room.name = "room " + std::to_string(room.id);
    room.T_map_room = T * room.T_map_room * Pose2{0.0, 0.0, -0.5 * kPi};
    std::swap(room.width_m, room.height_m);
  }
  for (Door& door : map.doors) {
    door.face.room -= less;
    door.face.gap.wall = static_cast<std::uint8_t>((door.face.gap.wall + 1) % 4);
    if (!door.other_face) continue;
    door.other_face->room -= less;
    door.other_face->gap.wall = static_cast<std::uint8_t>((door.other_face->gap.wall + 1) % 4);
  }
  return map;
}

TEST(MapMerge, PutsTwoPartsOfABuildingTogether) {
  const TopologicalMap whole = row_of_different_rooms();
  ASSERT_TRUE(check_map(whole).empty()) << check_map(whole).front();
  const TopologicalMap a = part_of(whole, {1, 2, 3});
  const TopologicalMap b = renumbered(part_of(whole, {2, 3, 4, 5}), 1, {3.0, -7.0, 0.8});
  const MergedMaps merged = merge_maps(a, b);
  EXPECT_EQ(merged.common, (std::vector<std::pair<RoomId, RoomId>>{{2, 1}, {3, 2}}));
  ASSERT_EQ(merged.map.rooms.size(), 5u);
  for (const Room& room : whole.rooms) {
    const Room& found = *merged.map.find_room(room.id);
    EXPECT_NEAR(iou(room.rectangle(), found.rectangle()), 1.0, 1e-9) << room.id;
    EXPECT_EQ(found.name, room.name);
  }
  EXPECT_EQ(merged.map.doors.size(), 4u);
  EXPECT_TRUE(check_map(merged.map).empty());
  EXPECT_NEAR(
      find_route(merged.map, middle_of(merged.map.rooms[0]), middle_of(merged.map.rooms[4]))->length_m,
      find_route(whole, middle_of(whole.rooms[0]), middle_of(whole.rooms[4]))->length_m, 1e-9);
}

TEST(MapMerge, RefusesWhatFitsInNoWayOrInSeveral) {
  EXPECT_THROW(merge_maps(two_rooms(), row_of_rooms(2)), std::invalid_argument);
  const TopologicalMap middle = part_of(row_of_rooms(5), {2, 3, 4});
  EXPECT_THROW(merge_maps(middle, part_of(middle, {2, 3})), std::invalid_argument);
  const TopologicalMap square = row_of_rooms(1);
  EXPECT_THROW(merge_maps(square, square), std::invalid_argument);
}

TEST(MapCheck, FindsNothingWrongWithASoundMap) {
  EXPECT_TRUE(check_map(two_rooms({1.0, 2.0, 0.7})).empty());
  EXPECT_TRUE(check_map(row_of_rooms(5)).empty());
}

std::string first_found(const TopologicalMap& map) {
  const auto found = check_map(map);
  return found.empty() ? "" : found.front();
}

TEST(MapCheck, NamesWhatCannotBe) {
  TopologicalMap map = two_rooms();
  map.rooms[1].T_map_room.x_m -= 0.5;
  EXPECT_EQ(first_found(map), "rooms 1 and 2 overlap by 0.35 m");
  map = two_rooms();
  map.rooms[1].T_map_room.y_m += 1.0;
  EXPECT_NE(first_found(map).find("1.00 m apart along the wall"), std::string::npos);
  map = two_rooms();
  map.rooms[0].width_m = 0.2;
  EXPECT_NE(first_found(map).find("no room has such a size"), std::string::npos);
  map = two_rooms();
  map.doors[0].kind = DoorKind::kUnresolved;
  map.doors[0].other_face.reset();
  EXPECT_NE(first_found(map).find("door 1 of room 1 is unmatched"), std::string::npos);
  map = two_rooms();
  map.doors.push_back({.id = 2, .kind = DoorKind::kExit, .face = {1, {0, 2.2, 3.0}}});
  EXPECT_NE(first_found(map).find("doors 1 and 2 lie over one another"), std::string::npos);
  map = two_rooms();
  map.doors.clear();
  EXPECT_EQ(first_found(map), "room 2 cannot be reached from room 1: no passage leads there");
}

}  // namespace
}  // namespace enfilade::topo_graph
