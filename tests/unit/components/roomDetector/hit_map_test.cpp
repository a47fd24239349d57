// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/hit_map.hpp"

#include <random>

#include <gtest/gtest.h>

namespace enfilade::room_detector {
namespace {

std::vector<CellHit> random_hits(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> metres(-1.0F, 3.0F);
  std::vector<CellHit> hits;
  for (int i = 0; i < 500; ++i) {
    const float x = metres(random), y = 0.1F * metres(random), z = metres(random);
    hits.push_back({x, y, z, static_cast<std::uint16_t>(1 + random() % 5)});
  }
  return hits;
}

void expect_same_columns(const HitMap& a, const HitMap& b) {
  ASSERT_EQ(a.columns().size(), b.columns().size());
  for (std::size_t i = 0; i < a.columns().size(); ++i) {
    EXPECT_EQ(a.columns()[i].key, b.columns()[i].key);
    EXPECT_EQ(a.columns()[i].sum.count, b.columns()[i].sum.count);
    EXPECT_NEAR(a.columns()[i].sum.x_m, b.columns()[i].sum.x_m, 1e-5);
    EXPECT_NEAR(a.columns()[i].sum.z_m, b.columns()[i].sum.z_m, 1e-5);
  }
}

TEST(HitMap, KeepsTheColumnsOfABandAsReturnsCome) {
  const WallBand band{20, 50, true}, other{0, 30, false};
  HitMap followed_first, followed_last, followed_another;
  followed_first.follow(band);
  followed_another.follow(other);
  for (unsigned seed = 0; seed < 4; ++seed) {
    for (HitMap* map : {&followed_first, &followed_last, &followed_another})
      map->add(random_hits(seed), 0.05);
  }
  followed_last.follow(band);
  followed_another.follow(band);
  expect_same_columns(followed_first, followed_last);
  expect_same_columns(followed_another, followed_last);
  EXPECT_GT(followed_last.columns().size(), 100u);
}

TEST(HitMap, SumsUpByColumnWhatLiesInTheBandOnly) {
  HitMap map;
  map.follow({20, 50, true});  // from 0.2 m to 1.7 m
  map.add(
      {{0.01F, 0.02F, 0.5F, 2}, {0.03F, 0.02F, 1.5F, 1}, {0.01F, 0.02F, 1.9F, 7}, {0.01F, 0.02F, 0.1F, 7}},
      0.05);
  ASSERT_EQ(map.columns().size(), 1u);
  const HitMap::Sum& sum = map.columns()[0].sum;
  EXPECT_EQ(sum.count, 3.0);
  EXPECT_NEAR(sum.x_m / sum.count, (2 * 0.01 + 0.03) / 3.0, 1e-6);
  EXPECT_NEAR(sum.z_m / sum.count, (2 * 0.5 + 1.5) / 3.0, 1e-6);
}

}  // namespace
}  // namespace enfilade::room_detector
