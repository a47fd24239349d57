// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/map_problem.hpp"

#include "tests/unit/components/topoGraph/rooms.hpp"

namespace enfilade::topo_graph {
namespace {

using namespace test;

/// Three rooms in a row; door 1 was measured on the way through, door 2 was not.
TopologicalMap three_rooms(std::optional<double> measured_m) {
  TopologicalMap map;
  for (int i = 0; i < 3; ++i) {
    Room room{.id = static_cast<RoomId>(i + 1), .T_map_room = {4.1 * i, 0.0, 0.0}, .width_m = 4.0};
    room.height_m = 3.0;
    map.rooms.push_back(room);
    if (i == 0) continue;
    Door door{.id = static_cast<DoorId>(i), .kind = DoorKind::kPassage};
    door.face = {static_cast<RoomId>(i), {0, 1.0, 2.0}};
    door.other_face = DoorFace{static_cast<RoomId>(i + 1), {2, 1.0, 2.0}};
    map.doors.push_back(door);
    map.links.push_back(
        {.from = static_cast<RoomId>(i), .to = static_cast<RoomId>(i + 1), .T_from_to = {4.1, 0.0, 0.0}});
  }
  map.doors[0].measured_thickness_m = measured_m;
  return map;
}

TEST(MapProblem, ExpectsOfAWallWhatIsConfiguredWhereNoneWasMeasured) {
  const UncertaintyConfig config;
  const MapProblem problem = map_problem(three_rooms(std::nullopt), config);
  EXPECT_DOUBLE_EQ(problem.problem.doors[0].thickness_m, config.thickness_m);
  EXPECT_DOUBLE_EQ(problem.problem.doors[1].thickness_m, config.thickness_m);
  EXPECT_GE(problem.problem.doors[1].sigma_thickness_m, config.thickness_sigma_m);
}

TEST(MapProblem, BelievesAWallThatWasMeasuredAndExpectsTheOthersToBeLikeIt) {
  const UncertaintyConfig config;
  const MapProblem problem = map_problem(three_rooms(0.10), config);
  EXPECT_DOUBLE_EQ(problem.problem.doors[0].thickness_m, 0.10);
  EXPECT_LT(problem.problem.doors[0].sigma_thickness_m, config.thickness_sigma_m);
  EXPECT_GT(problem.problem.doors[1].thickness_m, 0.10);
  EXPECT_LT(problem.problem.doors[1].thickness_m, 0.13);
}

TEST(MapProblem, BelievesAMeasuredWallLessWhereOdometryMissesTheDoors) {
  TopologicalMap map = three_rooms(0.10);
  const double before = map_problem(map, {}).problem.doors[0].sigma_thickness_m;
  map.links[1].T_from_to.y_m += 0.25;
  EXPECT_GT(map_problem(map, {}).problem.doors[0].sigma_thickness_m, 3.0 * before);
}

}  // namespace
}  // namespace enfilade::topo_graph
