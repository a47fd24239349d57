// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include <gtest/gtest.h>

#include "components/roomDetector/core/room_detector.hpp"
#include "tests/unit/components/roomDetector/ideal_room.hpp"

/// Whatever comes in, the answer is defined.
namespace enfilade::room_detector {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

RoomDetector detector_in_a_room() {
  RoomDetector detector({});
  detector.clear(0.05);
  detector.update(test::ideal_room([](double, double, double) { return CellState::kOccupied; }));
  return detector;
}

void expect_the_room(const Detection& d) {
  ASSERT_TRUE(d.estimate.found);
  EXPECT_NEAR(d.estimate.rectangle.area_m2(), 4.05 * 3.05, 0.5);
}

TEST(HardInputs, ReturnsThatAreNoNumbersChangeNothing) {
  RoomDetector detector = detector_in_a_room();
  detector.add_hits(
      {.hits = {{kNan, 0, 1, 1}, {0, kInfinity, 1, 1}, {0, 0, -kInfinity, 1}, {1e30F, 1, 1, 1}}});
  expect_the_room(detector.estimate(Pose2{}));
}

TEST(HardInputs, ReturnsOfNoWeightChangeNothing) {
  RoomDetector detector = detector_in_a_room();
  detector.add_hits({.hits = std::vector<CellHit>(1000)});
  expect_the_room(detector.estimate(Pose2{}));
}

TEST(HardInputs, AMillionReturnsInOneCellTakeTheRoomOfOne) {
  RoomDetector detector = detector_in_a_room();
  ScanHits line{.hits = std::vector<CellHit>(1000, {2.02F, 0.1F, 2.2F, 1000})};
  for (int i = 0; i < 1000; ++i) detector.add_hits(line);
  expect_the_room(detector.estimate(Pose2{}));
}

TEST(HardInputs, ReturnsFromNowhereChangeNothing) {
  RoomDetector detector = detector_in_a_room();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 100; ++i)
    detector.add_hits({.T_zone_base = {nan, 0, 0}, .hits = {{2.02F, 0.1F, 2.2F, 1}}});
  const Detection d = detector.estimate(Pose2{});
  ASSERT_TRUE(d.estimate.found);
  EXPECT_TRUE(std::isfinite(d.estimate.rectangle.width_m));
}

TEST(HardInputs, ARobotThatIsNowhereIsARobotOfWhichNothingIsKnown) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Pose2& nowhere : {Pose2{nan, 0, 0}, Pose2{0, nan, 0}, Pose2{0, 0, nan}, Pose2{1e300, 0, 0}}) {
    RoomDetector detector = detector_in_a_room();
    expect_the_room(detector.estimate(nowhere));
  }
}

TEST(HardInputs, ABlockWithoutAnythingFreeInItIsAnswered) {
  RoomDetector detector({});
  detector.clear(0.05);
  GridChange block{.sequence = 1, .resolution_m = 0.05};
  for (std::int16_t x = -40; x < 40; ++x)
    for (std::int16_t y = -40; y < 40; ++y)
      for (std::int16_t z = 0; z < 52; ++z) block.cells.push_back({x, y, z, CellState::kOccupied});
  detector.update(block);
  const Detection d = detector.estimate(Pose2{});
  EXPECT_LT(d.estimate.rectangle.area_m2(), 4.2 * 4.2) << "none, or one no larger than the block";
  EXPECT_TRUE(std::isfinite(d.estimate.score));
}

TEST(HardInputs, OneWallAloneIsNoRoom) {
  RoomDetector detector({});
  detector.clear(0.05);
  GridChange wall{.sequence = 1, .resolution_m = 0.05};
  for (std::int16_t y = -60; y < 60; ++y)
    for (std::int16_t z = 0; z < 52; ++z) wall.cells.push_back({40, y, z, CellState::kOccupied});
  detector.update(wall);
  EXPECT_FALSE(detector.estimate(Pose2{}).estimate.found);
}

TEST(HardInputs, AnEmptyGridIsExplainedToo) {
  RoomDetector detector({});
  detector.clear(0.05);
  const Detection d = detector.estimate(Pose2{});
  EXPECT_FALSE(d.estimate.found);
  EXPECT_FALSE(detector.explain(d).found);
}

TEST(HardInputs, TheScoreIsTheSumOfItsTerms) {
  RoomDetector detector = detector_in_a_room();
  const Detection d = detector.estimate(Pose2{});
  const RoomDiagnostics why = detector.explain(d);
  double sum = why.interior;
  for (const WallDiagnostics& wall : why.walls) sum += wall.occupied + wall.free + wall.toll;
  EXPECT_NEAR(sum, d.estimate.score, 1e-6);
  EXPECT_NEAR(why.interior, 0.0, 1e-6) << "nothing stands in it";
  for (const WallDiagnostics& wall : why.walls) EXPECT_GT(wall.occupied, 0.0);
  ASSERT_FALSE(why.rejected.empty());
  for (const RejectedRectangle& other : why.rejected) EXPECT_LT(other.score, why.score);
  EXPECT_EQ(why.slice.levels.size(), static_cast<std::size_t>(why.slice.columns) * why.slice.rows);
}

TEST(HardInputs, CellsAsHighAsTheWallBandOrABandUpsideDownAreNoEndlessSearch) {
  for (const auto& [resolution_m, to_m] :
       {std::pair{1.0, 2.4}, std::pair{0.05, 2.06}, std::pair{0.05, 1.9}}) {
    RoomDetectorConfig config;
    config.band.wall_band_to_m = to_m;
    RoomDetector detector(config);
    detector.clear(resolution_m);
    EXPECT_FALSE(detector.estimate(Pose2{}).estimate.found);
  }
}

}  // namespace
}  // namespace enfilade::room_detector
