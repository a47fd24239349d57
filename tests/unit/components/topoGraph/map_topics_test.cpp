// SPDX-License-Identifier: Apache-2.0
// What topoGraph tells of its map to those who do not know its graph: rt/map and routes.
#include <regex>

#include <gtest/gtest.h>

#include "components/topoGraph/metric_map/map_formats.hpp"
#include "components/topoGraph/node/topo_graph_node.hpp"
#include "tests/support/node_harness.hpp"
#include "tests/unit/components/topoGraph/rooms.hpp"

namespace enfilade::topo_graph {
namespace {

using namespace test;
using Harness = NodeHarness<TopoGraphNode, TopoGraphConfig>;

struct TopoGraphMapTopics : testing::Test {
  /// Two rooms with doors 1 and 2 between them.
  void explore() {
    const auto doors1 = {door_from_room1(), second_from_room1()};
    const auto doors2 = {door_from_room2(), second_from_room2()};
    harness->call(topics::kFixRoom, {call(1), estimate_of(room1(), 1, doors1)});
    harness->call(topics::kEnterZone, {call(2), 1, 1, {2.25, 0.55, 0.0}, from_seconds(0.5)});
    ASSERT_EQ(harness->call(topics::kFixRoom, {call(3), estimate_of(room2(), 2, doors2)})->room, 2u);
  }

  TopologicalMap graph() {
    auto& maps = harness->collect(topics::kTopologicalMap);
    harness->advance_s(0.0);
    return maps.back();
  }

  bool mark(DoorId door, bool closed) {
    return harness->call(topics::kMarkDoor, {{"enfilade", ++calls}, door, DoorKind::kUnresolved, closed})
        ->accepted;
  }

  RouteReply route(const RoutePlace& start, const RoutePlace& goal, std::vector<DoorId> closed = {}) {
    return harness->call(topics::kRoute, RouteRequest{{}, start, goal, std::move(closed)}).value();
  }

  TopoGraphConfig config;
  std::unique_ptr<Harness> harness = std::make_unique<Harness>("topoGraph", config);
  std::uint64_t calls = 100;
};

/// The cells of a PGM of map_server, lowest row first, as rt/map would have them.
std::vector<std::int8_t> cells_of(const std::string& pgm, std::uint32_t columns, std::uint32_t rows) {
  const std::string pixels = pgm.substr(pgm.size() - columns * rows);
  std::vector<std::int8_t> cells;
  for (std::uint32_t row = rows; row-- > 0;) {
    for (const char pixel : pixels.substr(row * columns, columns)) {
      const int grey = static_cast<unsigned char>(pixel);
      cells.push_back(static_cast<std::int8_t>(grey == 254 ? 0 : grey == 0 ? 100 : -1));
    }
  }
  return cells;
}

TEST_F(TopoGraphMapTopics, MapIsWhatTheExportWrites) {
  auto& maps = harness->collect(topics::kMap);
  explore();
  harness->advance_s(0.1);
  ASSERT_FALSE(maps.empty());
  const OccupancyMap& map = maps.back();
  const OccupancyGrid grid = draw_metric_map(graph(), {.resolution_m = 0.05});
  const std::string pgm = to_pgm(grid), yaml = to_map_server_yaml(grid, "map.pgm");

  std::smatch found;
  ASSERT_TRUE(std::regex_search(pgm, found, std::regex("\n(\\d+) (\\d+)\n255\n")));
  EXPECT_EQ(map.columns, std::stoul(found[1]));
  EXPECT_EQ(map.rows, std::stoul(found[2]));
  EXPECT_EQ(map.cells, cells_of(pgm, map.columns, map.rows));
  ASSERT_TRUE(std::regex_search(yaml, found, std::regex("origin: \\[([^,]*), ([^,]*), 0.0\\]")));
  EXPECT_EQ(map.T_frame_cells, (Transform3{.x_m = std::stod(found[1]), .y_m = std::stod(found[2])}));
  EXPECT_EQ(map.resolution_m, 0.05F);
  EXPECT_EQ(map.frame_id, "map");
}

TEST_F(TopoGraphMapTopics, MapIsDrawnOnceForEachChangeOfTheGraph) {
  auto& maps = harness->collect(topics::kMap);
  harness->advance_s(0.5);
  EXPECT_TRUE(maps.empty());  // there is no room yet
  explore();
  harness->advance_s(1.0);
  const std::size_t before = maps.size();
  EXPECT_LE(before, 2u);
  ASSERT_TRUE(mark(1, true));
  harness->advance_s(1.0);
  ASSERT_EQ(maps.size(), before + 1);
  EXPECT_NE(maps.back().cells, maps[before - 1].cells);  // a closed door is wall
  ASSERT_TRUE(mark(1, false));
  harness->advance_s(1.0);
  ASSERT_EQ(maps.size(), before + 2);
  EXPECT_EQ(maps.back().cells, maps[before - 1].cells);
}

TEST_F(TopoGraphMapTopics, MapIsThereForWhoComesLate) {
  explore();
  harness->advance_s(1.0);
  auto& maps = harness->collect(topics::kMap);
  harness->advance_s(0.2);
  EXPECT_EQ(maps.size(), 1u);
}

TEST_F(TopoGraphMapTopics, MapHasCoarserCellsRatherThanTooMany) {
  config.metric_map.max_cells = 2000;
  harness = std::make_unique<Harness>("topoGraph", config);
  auto& maps = harness->collect(topics::kMap);
  explore();
  harness->advance_s(0.1);
  ASSERT_FALSE(maps.empty());
  EXPECT_LE(maps.back().cells.size(), 2000u);
  EXPECT_EQ(maps.back().resolution_m, 0.2F);
  EXPECT_NE(harness->logged().back().text.find("0.2"), std::string::npos);
}

TEST_F(TopoGraphMapTopics, MapIsLeftOutWhereItIsNotWanted) {
  config.metric_map.resolution_m = 0.0;
  harness = std::make_unique<Harness>("topoGraph", config);
  auto& maps = harness->collect(topics::kMap);
  explore();
  harness->advance_s(0.1);
  EXPECT_TRUE(maps.empty());
}

TEST_F(TopoGraphMapTopics, RoutesGoFromDoorToDoorBetweenRoomsAndPoints) {
  explore();
  const RouteReply reply = route({.point = {0.0, 0.55}}, {.room = 2});
  ASSERT_TRUE(reply.found) << reply.message;
  ASSERT_EQ(reply.route.legs.size(), 2u);
  EXPECT_EQ(reply.route.legs[0].room, 1u);
  EXPECT_EQ(reply.route.legs[0].door, DoorId{1});
  EXPECT_NEAR((reply.route.legs[0].leave - Point2(1.6, 0.55)).norm(), 0.0, 1e-6);
  EXPECT_EQ(reply.route.legs[1].room, 2u);
  EXPECT_FALSE(reply.route.legs[1].door);
  EXPECT_NEAR(reply.route.length_m, 1.75 + std::hypot(2.1, 0.55), 1e-6);
}

TEST_F(TopoGraphMapTopics, RoutesGoRoundDoorsThatAreClosed) {
  explore();
  EXPECT_EQ(route({.room = 1}, {.room = 2}, {1}).route.legs.at(0).door, DoorId{2});
  ASSERT_TRUE(mark(1, true));
  EXPECT_EQ(route({.room = 1}, {.room = 2}).route.legs.at(0).door, DoorId{2});
  ASSERT_TRUE(mark(2, true));
  const RouteReply none = route({.room = 1}, {.room = 2});
  EXPECT_FALSE(none.found);
  EXPECT_EQ(none.message, "no way leads from room 1 to room 2 through doors that are open");
  ASSERT_TRUE(mark(1, false));
  EXPECT_EQ(route({.room = 1}, {.room = 2}).route.legs.at(0).door, DoorId{1});
}

TEST_F(TopoGraphMapTopics, RoutesSayWhyThereIsNone) {
  explore();
  EXPECT_EQ(route({.room = 1}, {.room = 7}).message, "there is no room 7");
  EXPECT_EQ(route({.point = {50.0, 0.0}}, {.room = 1}).message, "the point 50.000,0.000 lies in no room");
  EXPECT_EQ(route({.room = 1}, {.room = 2}, {9}).message, "there is no door 9");
}

}  // namespace
}  // namespace enfilade::topo_graph
