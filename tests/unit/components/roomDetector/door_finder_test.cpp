// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/door_finder.hpp"

#include <gtest/gtest.h>

#include "components/roomDetector/core/paper_doors.hpp"
#include "tests/unit/components/roomDetector/ideal_room.hpp"

namespace enfilade::room_detector {
namespace {

// Wall 0 is x = +2, running from (2, -1.5) to (2, 1.5): y = -0.5 … 0.4 is 1.0 … 1.9 m along it.
constexpr Rectangle kDoorlessRoom{0.0, 0.0, 0.0, 4.05, 3.05};
bool in_gap(double x, double y) { return x > 2.0 && y > -0.5 && y < 0.4; }

WallGaps gaps_of(const std::function<CellState(double, double, double)>& wall_state,
                 double resolution_m = 0.05) {
  ColumnMap map;
  map.clear(resolution_m);
  map.apply(test::ideal_room(wall_state, resolution_m).cells);
  const Rectangle room{0.0, 0.0, 0.0, 4.0 + resolution_m,
                       3.0 + resolution_m};  // through the middle of the wall cells
  return DoorFinder({}).find(map, room);
}

TEST(DoorFinder, FindsADoorWithItsEndsAndItsLintel) {
  const auto gaps = gaps_of([](double x, double y, double z) {
    return in_gap(x, y) && z < 2.0 ? CellState::kFree : CellState::kOccupied;
  });
  ASSERT_EQ(gaps.doors.size(), 1u);
  const DoorEstimate& door = gaps.doors[0];
  EXPECT_EQ(door.state, DoorState::kOpen);
  EXPECT_EQ(door.gap.wall, 0);
  EXPECT_NEAR(door.gap.from_m, 1.025, 0.026);
  EXPECT_NEAR(door.gap.to_m, 1.925, 0.026);
  ASSERT_TRUE(door.height_m);
  EXPECT_NEAR(*door.height_m, 2.0, 1e-9);
  EXPECT_GT(door.evidence.beyond_free_cells, 0u);
  EXPECT_EQ(door.evidence.beyond_occupied_cells, 0u);
  EXPECT_NEAR(gaps.unexplored_share, 0.0, 0.03);
}

TEST(DoorFinder, CallsWhatWasNotObservedUnexploredAndNotADoor) {
  const auto gaps = gaps_of([](double x, double y, double) {
    return in_gap(x, y) ? CellState::kUnexplored : CellState::kOccupied;
  });
  ASSERT_EQ(gaps.doors.size(), 1u);
  EXPECT_EQ(gaps.doors[0].state, DoorState::kUnexplored);
  EXPECT_NEAR(gaps.unexplored_share, 0.9 / 14.0, 0.02);
}

TEST(DoorFinder, DoesNotTakeAWindowForADoor) {
  const auto gaps = gaps_of([](double x, double y, double z) {
    return in_gap(x, y) && z > 0.9 && z < 2.0 ? CellState::kFree : CellState::kOccupied;
  });
  EXPECT_TRUE(gaps.doors.empty());
}

TEST(DoorFinder, OnlyDeemsAnOpeningPossibleWhoseFootIsHidden) {
  const auto gaps = gaps_of([](double x, double y, double z) {
    if (!in_gap(x, y)) return CellState::kOccupied;
    return z > 0.9 ? CellState::kFree : CellState::kUnexplored;
  });
  ASSERT_EQ(gaps.doors.size(), 1u);
  EXPECT_EQ(gaps.doors[0].state, DoorState::kPossible);
}

TEST(DoorFinder, TellsADoorFromTheUnexploredWallBesideIt) {
  const auto gaps = gaps_of([](double x, double y, double) {
    if (in_gap(x, y)) return CellState::kFree;
    return x > 2.0 && y > 0.4 && y < 1.0 ? CellState::kUnexplored : CellState::kOccupied;
  });
  ASSERT_EQ(gaps.doors.size(), 2u);
  EXPECT_EQ(gaps.doors[0].state, DoorState::kOpen);
  EXPECT_NEAR(gaps.doors[0].gap.width_m(), 0.9, 0.06);
  EXPECT_EQ(gaps.doors[1].state, DoorState::kUnexplored);
  EXPECT_NEAR(gaps.doors[1].gap.width_m(), 0.6, 0.06);
}

TEST(DoorFinder, FindsTheSameDoorAtAnotherResolution) {
  const auto gaps =
      gaps_of([](double x, double y,
                 double z) { return in_gap(x, y) && z < 2.0 ? CellState::kFree : CellState::kOccupied; },
              0.1);
  ASSERT_EQ(gaps.doors.size(), 1u);
  EXPECT_EQ(gaps.doors[0].state, DoorState::kOpen);
  EXPECT_NEAR(gaps.doors[0].gap.width_m(), 0.9, 0.11);
}

constexpr Rectangle kDoorRoom{0.0, 0.0, 0.0, 4.05, 3.05};  // through the middle of the wall cells

/// The room with an opening between `from` and `to` along wall 0, free from the floor to `top_m`.
ColumnMap room_with_gap(double from_m, double to_m, double top_m = 2.0) {
  ColumnMap map;
  map.clear(0.05);
  map.apply(test::ideal_room([&](double x, double y, double z) {
              const double along = y + 1.5;
              return x > 2.0 && along > from_m && along < to_m && z < top_m ? CellState::kFree
                                                                            : CellState::kOccupied;
            }).cells);
  return map;
}

/// Returns of a wall `depth_m` behind wall 0, seen from the middle of the room.
HitMap seen_behind(float depth_m) {
  std::vector<CellHit> hits;
  for (float y = -0.5F; y < 0.4F; y += 0.01F)
    hits.push_back({2.025F + depth_m, y * (2.025F + depth_m) / 2.025F, 1.0F, 1});
  HitMap seen;
  seen.add(hits, 0.05);
  return seen;
}

WallGaps gaps_seen(const ColumnMap& map, const HitMap& seen) {
  const std::vector<Sightings> sightings{{Point2::Zero(), {&seen}}};
  return DoorFinder({}).find(map, kDoorRoom, {}, sightings);
}

TEST(DoorFinder, FindsADoubleDoorWhole) {
  const auto gaps = DoorFinder({}).find(room_with_gap(0.5, 2.3), kDoorRoom);
  ASSERT_EQ(gaps.doors.size(), 1u);
  EXPECT_EQ(gaps.doors[0].state, DoorState::kOpen);
  EXPECT_NEAR(gaps.doors[0].gap.width_m(), 1.8, 0.06);
}

TEST(DoorFinder, FindsADoorInACorner) {
  const auto gaps = DoorFinder({}).find(room_with_gap(0.1, 0.95), kDoorRoom);
  ASSERT_EQ(gaps.doors.size(), 1u);
  EXPECT_EQ(gaps.doors[0].state, DoorState::kOpen);
  EXPECT_NEAR(gaps.doors[0].gap.from_m, 0.1, 0.06);
  EXPECT_NEAR(gaps.doors[0].gap.to_m, 0.975, 0.06);
}

TEST(DoorFinder, FindsADoorWithAWallHalfAMetreBehindIt) {
  const auto gaps = gaps_seen(room_with_gap(1.0, 1.9), seen_behind(0.5F));
  ASSERT_EQ(gaps.doors.size(), 1u);
  EXPECT_EQ(gaps.doors[0].state, DoorState::kOpen);
  EXPECT_NEAR(gaps.doors[0].gap.width_m(), 0.9, 0.06);
}

TEST(DoorFinder, OnlyDeemsAnOpeningPossibleThroughWhichNothingWasSeen) {
  const auto gaps = gaps_seen(room_with_gap(1.0, 1.9), seen_behind(0.0F));
  ASSERT_EQ(gaps.doors.size(), 1u);
  EXPECT_EQ(gaps.doors[0].state, DoorState::kPossible) << "it may be glass";
}

TEST(DoorFinder, SaysHowWellADoorIsKnown) {
  const auto gaps = DoorFinder({}).find(room_with_gap(1.0, 1.9), kDoorRoom);
  ASSERT_EQ(gaps.doors.size(), 1u);
  EXPECT_NEAR(gaps.doors[0].width_sigma_m, 2.0 * gaps.doors[0].position_sigma_m, 1e-12);
  EXPECT_GT(gaps.doors[0].width_sigma_m, 0.01) << "no returns: known to cells";
  EXPECT_GT(gaps.doors[0].height_sigma_m, 0.01);
}

TEST(DoorFinder, SaysWhyAWindowIsNoDoor) {
  const auto gaps = gaps_of([](double x, double y, double z) {
    return in_gap(x, y) && z > 0.9 && z < 2.0 ? CellState::kFree : CellState::kOccupied;
  });
  ASSERT_EQ(gaps.diagnostics.size(), 1u);
  EXPECT_EQ(gaps.diagnostics[0].verdict, GapVerdict::kNoDoor);
  EXPECT_NE(gaps.diagnostics[0].reason.find("sill"), std::string::npos);
}

TEST(PaperDoors, AreTheSegmentsWithoutPoints) {
  ColumnMap map;
  map.clear(0.05);
  map.apply(test::ideal_room([](double x, double y, double) {
              return in_gap(x, y) ? CellState::kUnexplored : CellState::kOccupied;
            }).cells);
  const auto doors = find_paper_doors(map, HoughLattice(HoughConfig{}), Point2::Zero(), kDoorlessRoom, {});
  ASSERT_EQ(doors.size(), 1u);
  EXPECT_NEAR(doors[0].gap.from_m, 1.025, 0.026);
  EXPECT_NEAR(doors[0].gap.to_m, 1.925, 0.026);
}

TEST(PaperDoors, AreNotFoundUnderALintel) {
  ColumnMap map;
  map.clear(0.05);
  map.apply(test::ideal_room([](double x, double y, double z) {
              return in_gap(x, y) && z < 2.0 ? CellState::kFree : CellState::kOccupied;
            }).cells);
  EXPECT_TRUE(find_paper_doors(map, HoughLattice(HoughConfig{}), Point2::Zero(), kDoorlessRoom, {}).empty());
}

}  // namespace
}  // namespace enfilade::room_detector
