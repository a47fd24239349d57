// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/jamb_fit.hpp"

#include <gtest/gtest.h>

namespace enfilade::room_detector {
namespace {

// Wall 0 of a turned room runs 3 m; its door is 1.013 … 1.907 m along it, in cells 1.05 … 1.85 m.
const Rectangle kJambRoom{0.4, 1.0, -2.0, 4.0, 3.0};
constexpr double kFrom_m = 1.013, kTo_m = 1.907;
constexpr WallInterval kCells{0, 1.05, 1.85};

Point2 on_wall(double along_m, double outside_m) {
  return kJambRoom.corner(0) + along_m * kJambRoom.wall(0).direction() + outside_m * kJambRoom.normal(0);
}

void add_face(std::vector<WallPoint>& hits) {
  for (double s = 0.0; s <= 3.0; s += 0.004) {
    if (s <= kFrom_m || s >= kTo_m) hits.push_back({on_wall(s, 0.0), 1.0});
  }
}

void add_reveals(std::vector<WallPoint>& hits) {
  for (double depth = 0.01; depth < 0.15; depth += 0.004) {
    hits.push_back({on_wall(kFrom_m, depth), 1.0});
    hits.push_back({on_wall(kTo_m, depth), 1.0});
  }
}

WallInterval fitted(const std::vector<WallPoint>& points) {
  std::vector<CellHit> returns;
  for (const WallPoint& p : points)
    returns.push_back({static_cast<float>(p.position.x()), static_cast<float>(p.position.y()), 1.0F,
                       static_cast<std::uint16_t>(p.weight)});
  HitMap seen;
  seen.add(returns, 3.0, 0.01);
  const std::vector<PlacedHits> hits{{&seen}};
  return fit_jambs(hits_beside(hits, kJambRoom, kCells, {}), kCells, {}).gap;
}

TEST(FitJambs, StaysAtTheCellsWhereNothingWasSeen) { EXPECT_EQ(fitted({}), kCells); }

TEST(FitJambs, FindsTheJambsThemselves) {
  std::vector<WallPoint> hits;
  add_reveals(hits);
  EXPECT_NEAR(fitted(hits).from_m, kFrom_m, 0.005);
  EXPECT_NEAR(fitted(hits).to_m, kTo_m, 0.005);
}

TEST(FitJambs, FindsWhereTheFaceOfTheWallEnds) {
  std::vector<WallPoint> hits;
  add_face(hits);
  EXPECT_NEAR(fitted(hits).from_m, kFrom_m, 0.01);
  EXPECT_NEAR(fitted(hits).to_m, kTo_m, 0.01);
}

TEST(FitJambs, BelievesTheJambWhereFurnitureHidesTheFace) {
  std::vector<WallPoint> hits;
  add_face(hits);
  std::erase_if(hits,
                [](const WallPoint& hit) { return (hit.position - on_wall(kTo_m, 0.0)).norm() < 0.12; });
  add_reveals(hits);
  EXPECT_NEAR(fitted(hits).to_m, kTo_m, 0.005);
}

TEST(FitJambs, DoesNotTakeTheNoiseOfTheFaceForAJamb) {
  std::vector<WallPoint> hits;
  add_face(hits);
  for (const WallPoint& hit : std::vector(hits)) {
    if ((hit.position - on_wall(kFrom_m, 0.0)).norm() < 0.06) continue;
    for (const double noise : {0.05, 0.07, 0.09})
      hits.push_back({hit.position + noise * kJambRoom.normal(0), 1.0});
  }
  EXPECT_NEAR(fitted(hits).from_m, kFrom_m, 0.015);
  EXPECT_NEAR(fitted(hits).to_m, kTo_m, 0.015);
}

TEST(FitJambs, IsNotLedAstrayByWhatStandsInTheNextRoom) {
  std::vector<WallPoint> hits;
  add_face(hits);
  for (double s = 1.1; s < 1.8; s += 0.004) hits.push_back({on_wall(s, 0.3), 1.0});  // a cupboard's flat back
  EXPECT_NEAR(fitted(hits).from_m, kFrom_m, 0.01);
  EXPECT_NEAR(fitted(hits).to_m, kTo_m, 0.01);
}

}  // namespace
}  // namespace enfilade::room_detector
