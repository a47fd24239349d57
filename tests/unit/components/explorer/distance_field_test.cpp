// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/distance_field.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace enfilade::explorer {
namespace {

/// The slow obvious way.
float nearest(const std::vector<std::uint8_t>& set, int width, int height, int x, int y) {
  float best = 1e9F;
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      if (set[static_cast<std::size_t>(j * width + i)])
        best = std::min(best, std::hypot(float(i - x), float(j - y)));
    }
  }
  return best;
}

TEST(DistanceField, IsTheDistanceToTheNearestSetCell) {
  constexpr int kWidth = 37, kHeight = 23;
  for (std::uint32_t seed = 1; seed < 6; ++seed) {
    std::vector<std::uint8_t> set(kWidth * kHeight);
    std::uint32_t state = seed;
    for (auto& cell : set) cell = ((state = state * 1664525U + 1013904223U) >> 24) < 4;
    set[100] = 1;
    const auto field = distance_field(set, kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        ASSERT_FLOAT_EQ(field[static_cast<std::size_t>(y * kWidth + x)], nearest(set, kWidth, kHeight, x, y));
      }
    }
  }
}

TEST(DistanceField, IsVeryLargeWhereNothingIsSet) {
  for (const float d : distance_field(std::vector<std::uint8_t>(20), 5, 4)) EXPECT_GT(d, 1000.0F);
  EXPECT_TRUE(distance_field({}, 0, 0).empty());
}

}  // namespace
}  // namespace enfilade::explorer
