// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/room_detector.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/unit/components/roomDetector/random_rooms.hpp"
#include "tests/unit/components/roomDetector/sim_grid.hpp"

namespace enfilade::room_detector {
namespace {

constexpr test::SimScanConfig kCoarse{.roll_step_deg = 3.0, .beam_step_deg = 1.0};

/// The detector after sweeps in place, `turns` of them a quarter turn apart.
Detection detect(const test::SimRoom& room, int turns, RoomDetectorConfig config = {},
                 double resolution_m = 0.05) {
  RoomDetector detector(config);
  test::SimGrid grid(resolution_m);
  detector.clear(resolution_m);
  Pose2 T_zone_base;
  for (int turn = 0; turn < turns; ++turn) {
    T_zone_base = room.T_zone_room * Pose2{0.1, -0.2, 0.4 + 0.5 * kPi * turn};
    for (const ScanHits& line : grid.sweep(room, T_zone_base, kCoarse)) detector.add_hits(line);
    detector.update(grid.changes());
  }
  return detector.estimate(T_zone_base);
}

test::SimRoom paper_room(const Pose2& T_zone_room = {}) {
  return test::RoomBuilder(4.20, 3.78, 2.6)
      .at(T_zone_room)
      .door(2, 1.4, 2.3)
      .box(1.0, 1.2, 2.1, 1.89, 1.2)
      .build();
}

void expect_same(const Rectangle& a, const Rectangle& b, double tolerance) {
  const Rectangle p = canonical(a).rectangle, q = canonical(b).rectangle;
  EXPECT_GT(iou(p, q), 1.0 - 2.0 * tolerance);
  EXPECT_NEAR(std::max(p.width_m, p.height_m), std::max(q.width_m, q.height_m), tolerance);
  EXPECT_NEAR(std::min(p.width_m, p.height_m), std::min(q.width_m, q.height_m), tolerance);
}

TEST(RoomDetector, MeasuresAFurnishedRoomToMillimetres) {
  const auto room = paper_room();
  const auto d = detect(room, 2);
  ASSERT_TRUE(d.estimate.found);
  EXPECT_TRUE(d.diagnostics.above_furniture);
  expect_same(d.estimate.rectangle, room.rectangle(), 0.005);
  ASSERT_TRUE(d.estimate.recent);
  expect_same(*d.estimate.recent, room.rectangle(), 0.01);
}

TEST(RoomDetector, RotatesAndShiftsWithTheWorld) {
  const auto at_home = detect(paper_room(), 2);
  for (const Pose2& T : {Pose2{3.0, -2.0, 0.3}, Pose2{-1.7, 4.1, -1.1}}) {
    const auto d = detect(paper_room(T), 2);
    ASSERT_TRUE(d.estimate.found);
    expect_same(d.estimate.rectangle, T * at_home.estimate.rectangle, 0.01);
  }
}

TEST(RoomDetector, WorksAtThePapersSamplingStep) {
  RoomDetectorConfig config;
  for (const double step : {0.02, 0.27, 0.5}) {
    config.hough.step_m = step;
    const auto room = paper_room({0.3, 0.2, 0.1});
    const auto d = detect(room, 2, config);
    ASSERT_TRUE(d.estimate.found) << step;
    expect_same(d.estimate.rectangle, room.rectangle(), 0.02);
  }
}

TEST(RoomDetector, DoesNotDependOnTheResolutionOfTheGrid) {
  const auto room = paper_room({0.3, 0.2, 0.1});
  const auto d = detect(room, 2, {}, 0.08);
  ASSERT_TRUE(d.estimate.found);
  expect_same(d.estimate.rectangle, room.rectangle(), 0.01);
}

TEST(RoomDetector, KeepsTheWallsOfASnapshotWhenTheFirstLineComes) {
  const auto room = paper_room();
  const Pose2 T_zone_base{0.1, -0.2, 0.4};
  test::SimGrid grid;
  const auto lines = grid.sweep(room, T_zone_base, kCoarse);
  RoomDetector restarted({});
  restarted.clear(grid.resolution_m());
  restarted.update(grid.changes());
  const auto before = restarted.estimate(T_zone_base);
  restarted.add_hits(lines[lines.size() / 4]);
  const auto after = restarted.estimate(T_zone_base);
  ASSERT_TRUE(before.diagnostics.fit && after.diagnostics.fit);
  for (std::size_t wall = 0; wall < 4; ++wall)
    EXPECT_GT(after.diagnostics.fit->support[wall], 0.5 * before.diagnostics.fit->support[wall]) << wall;
  expect_same(after.estimate.rectangle, room.rectangle(), 0.05);
}

TEST(RoomDetector, DescribesAnOutlineThatItDidNotChoose) {
  const auto room = paper_room({0.4, -0.3, 0.3});
  const Pose2 T_zone_base = room.T_zone_room * Pose2{0.1, -0.2, 0.4};
  RoomDetector detector({});
  EXPECT_FALSE(detector.describe(room.rectangle()).estimate.found) << "nothing is known yet";
  test::SimGrid grid;
  detector.clear(grid.resolution_m());
  for (const ScanHits& line : grid.sweep(room, T_zone_base, kCoarse)) detector.add_hits(line);
  detector.update(grid.changes());
  const auto chosen = detector.estimate(T_zone_base);
  Rectangle roughly = room.rectangle();
  roughly.width_m += 0.08;
  const auto described = detector.describe(roughly);
  ASSERT_TRUE(described.estimate.found);
  expect_same(described.estimate.rectangle, room.rectangle(), 0.005);
  EXPECT_EQ(described.estimate.doors.size(), chosen.estimate.doors.size());
  EXPECT_DOUBLE_EQ(detector.describe(chosen.diagnostics.coarse).estimate.score, chosen.estimate.score);
  roughly.x_m += 100.0;
  EXPECT_FALSE(detector.describe(roughly).estimate.found) << "beyond the Hough space";
}

TEST(RoomDetector, LooksAtTheTopOfLowWalls) {
  auto room = test::RoomBuilder(4.0, 3.0, 1.2).box(-2.0, -1.5, 2.0, -0.9, 0.6).build();
  room.boxes.pop_back();  // the ceiling
  const auto d = detect(room, 2);
  ASSERT_TRUE(d.estimate.found);
  EXPECT_TRUE(d.diagnostics.above_furniture);
  expect_same(d.estimate.rectangle, room.rectangle(), 0.02);
}

TEST(RoomDetector, IsNotMisledByALowCeiling) {
  const auto room = test::RoomBuilder(4.0, 3.0, 1.2).build();
  const auto d = detect(room, 2);
  ASSERT_TRUE(d.estimate.found);
  expect_same(d.estimate.rectangle, room.rectangle(), 0.02);
}

TEST(RoomDetector, FindsAHallThatACoarseScanShowsThinly) {
  const auto room = test::RoomBuilder(11.0, 4.6, 2.9).door(1, 3.0, 5.0).door(3, 4.0, 6.0).build();
  RoomDetector detector({});
  test::SimGrid grid(0.05);
  detector.clear(0.05);
  const Pose2 T_zone_base = room.T_zone_room * Pose2{-2.7, -0.6, 0.4};
  for (const ScanHits& line : grid.sweep(room, T_zone_base, {.roll_step_deg = 4.0, .beam_step_deg = 2.0}))
    detector.add_hits(line);
  detector.update(grid.changes());
  const auto d = detector.estimate(T_zone_base);
  ASSERT_TRUE(d.estimate.found);
  EXPECT_TRUE(d.diagnostics.above_furniture);
  EXPECT_GT(iou(d.estimate.rectangle, room.rectangle()), 0.95);
}

TEST(RoomDetector, FindsMostFurnishedRoomsAfterTwoSweeps) {
  int right = 0, doors = 0, false_doors = 0;
  std::vector<double> edge_errors_m;
  constexpr unsigned kRooms = 6;
  for (unsigned seed = 0; seed < kRooms; ++seed) {
    const auto room = test::RandomRooms(seed + 300).next();
    const auto d = detect(room, 2);
    if (!d.estimate.found || iou(d.estimate.rectangle, room.rectangle()) < 0.9) continue;
    ++right;
    for (const DoorEstimate& door : d.estimate.doors) {
      if (door.state != DoorState::kOpen) continue;
      const Point2 at = segment_of(d.estimate.rectangle, door.gap).midpoint();
      const auto truth = std::find_if(room.doors.begin(), room.doors.end(), [&](const WallInterval& gap) {
        return (segment_of(room.rectangle(), gap).midpoint() - at).norm() < 0.3;
      });
      ++(truth != room.doors.end() ? doors : false_doors);
      if (truth == room.doors.end()) continue;
      const Segment seen = segment_of(d.estimate.rectangle, door.gap),
                    real = segment_of(room.rectangle(), *truth);
      edge_errors_m.push_back((seen.from - real.from).norm());
      edge_errors_m.push_back((seen.to - real.to).norm());
    }
  }
  EXPECT_EQ(right, 6);
  EXPECT_GE(doors, 8);
  EXPECT_LE(false_doors, 1);
  std::sort(edge_errors_m.begin(), edge_errors_m.end());
  EXPECT_LE(edge_errors_m.at(edge_errors_m.size() / 2), 0.005);
}

/// Two rooms of the same width in one, 8 m long: a wall across it with a door, and lintel above that.
test::SimRoom two_rooms_in_line() {
  return test::RoomBuilder(8.0, 3.2, 2.6)
      .box(-0.1, -1.6, 0.1, -0.2, 2.6)
      .box(-0.1, 0.7, 0.1, 1.6, 2.6)
      .box(-0.1, -0.2, 0.1, 0.7, 2.6, 2.03)
      .build();
}

TEST(RoomDetector, StaysInItsRoomWhereTheWallsGoOnBehindTheDoor) {
  const auto both = two_rooms_in_line();
  RoomDetector detector({});
  test::SimGrid grid(0.05);
  detector.clear(0.05);
  const Pose2 stands[] = {{-2.1, 0.2, 0.4}, {-2.1, 0.2, 2.0}, {2.0, -0.1, 0.4}, {2.0, -0.1, 2.0}};
  for (const Pose2& stand : stands) {
    for (const ScanHits& line : grid.sweep(both, stand, kCoarse)) detector.add_hits(line);
  }
  detector.update(grid.changes());
  const auto d = detector.estimate(stands[3]);
  ASSERT_TRUE(d.estimate.found);
  EXPECT_GT(iou(d.estimate.rectangle, {0.0, 2.05, 0.0, 3.9, 3.2}), 0.95);
}

TEST(RoomDetector, FindsTheWallBehindCupboardsUpToTheCeiling) {
  const auto room = test::RoomBuilder(4.2, 3.6, 2.6)
                        .box(1.5, -1.8, 2.1, -0.6, 2.55)
                        .box(1.5, 0.9, 2.1, 1.8, 2.55)
                        .box(-1.2, 1.2, 0.4, 1.8, 2.5)
                        .build();
  const auto d = detect(room, 2);
  ASSERT_TRUE(d.estimate.found);
  EXPECT_GT(iou(d.estimate.rectangle, room.rectangle()), 0.97);
}

/// How many doors are open after one more sweep from the middle of the room.
std::ptrdiff_t open_doors_after(RoomDetector& detector, test::SimGrid& grid, const test::SimRoom& room) {
  const Pose2 T_zone_base{0.0, 0.0, 0.2};
  for (const ScanHits& line : grid.sweep(room, T_zone_base, {})) detector.add_hits(line);
  detector.update(grid.changes());
  const auto doors = detector.estimate(T_zone_base).estimate.doors;
  return std::count_if(doors.begin(), doors.end(),
                       [](const DoorEstimate& door) { return door.state == DoorState::kOpen; });
}

TEST(RoomDetector, FollowsADoorThatIsOpenedAndClosed) {
  const auto next_door = [](test::RoomBuilder builder) {  // something must be seen through it
    return builder.box(4.0, -3.0, 4.2, 3.0, 2.6).build();
  };
  const auto closed = next_door(test::RoomBuilder(4.0, 3.4, 2.6));
  const auto open = next_door(test::RoomBuilder(4.0, 3.4, 2.6).door(0, 1.3, 2.2));
  RoomDetector detector({});
  test::SimGrid grid(0.05);
  detector.clear(0.05);
  EXPECT_EQ(open_doors_after(detector, grid, closed), 0);
  std::ptrdiff_t seen = 0;
  for (int sweep = 0; sweep < 4 && seen == 0; ++sweep) seen = open_doors_after(detector, grid, open);
  EXPECT_EQ(seen, 1);
  for (int sweep = 0; sweep < 4 && seen > 0; ++sweep) seen = open_doors_after(detector, grid, closed);
  EXPECT_EQ(seen, 0);
}

TEST(RoomDetector, KeepsTheDoorsOfASnapshotWhenTheFirstLineComes) {
  const auto room = test::RoomBuilder(4.0, 3.4, 2.6).door(0, 1.3, 2.2).box(4.0, -3.0, 4.2, 3.0, 2.6).build();
  test::SimGrid grid(0.05);
  RoomDetector all_along({}), restarted({});
  const auto lines = grid.sweep(room, {0.1, -0.2, 0.4}, kCoarse);
  for (RoomDetector* detector : {&all_along, &restarted}) detector->clear(0.05);
  const GridChange cells = grid.changes();
  all_along.update(cells);
  for (const ScanHits& line : lines) all_along.add_hits(line);
  restarted.adopt(cells);
  restarted.add_hits(lines.front());
  const auto open_doors = [](RoomDetector& detector) {
    const auto doors = detector.estimate(Pose2{0.1, -0.2, 0.4}).estimate.doors;
    return std::count_if(doors.begin(), doors.end(),
                         [](const DoorEstimate& door) { return door.state == DoorState::kOpen; });
  };
  EXPECT_EQ(open_doors(all_along), 1);
  EXPECT_EQ(open_doors(restarted), 1);
}

TEST(RoomDetector, IsNotMisledByAPersonWhoWalksThroughTheScan) {
  RoomDetector detector({});
  test::SimGrid grid(0.05);
  detector.clear(0.05);
  const test::SimRoom room = paper_room();
  const Pose2 T_zone_base{0.1, -0.2, 0.4};
  for (const double x : {-1.6, -1.0, 1.0}) {
    test::SimRoom with_person = room;
    with_person.boxes.push_back({{x, 0.5, 0.0}, {x + 0.45, 0.95, 1.8}});
    for (const ScanHits& line : grid.sweep(with_person, T_zone_base, kCoarse)) detector.add_hits(line);
  }
  detector.update(grid.changes());
  const auto d = detector.estimate(T_zone_base);
  ASSERT_TRUE(d.estimate.found);
  expect_same(d.estimate.rectangle, room.rectangle(), 0.005);
}

TEST(RoomDetector, FindsNoRoomInACorridorWithoutEnds) {
  const auto corridor = test::RoomBuilder(40.0, 2.4, 2.9).build();
  EXPECT_FALSE(detect(corridor, 2).estimate.found);
}

TEST(RoomDetector, FindsNothingInNothing) {
  RoomDetector detector({});
  detector.clear(0.05);
  EXPECT_FALSE(detector.estimate(std::nullopt).estimate.found);
}

}  // namespace
}  // namespace enfilade::room_detector
