// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/lzf.hpp"

#include <random>

#include <gtest/gtest.h>

namespace enfilade::laser_3d {
namespace {

std::string bytes(std::initializer_list<int> values) {
  std::string out;
  for (const int value : values) out.push_back(static_cast<char>(value));
  return out;
}

TEST(Lzf, UnpacksLiterals) { EXPECT_EQ(unpack_lzf(bytes({2, 'a', 'b', 'c', 0, 'd'}), 4), "abcd"); }

TEST(Lzf, CopiesFromBackInTheOutput) {
  // "abcabc": three literals, then length field 1 (= 3 bytes) at distance field 2 (= 3 back).
  EXPECT_EQ(unpack_lzf(bytes({2, 'a', 'b', 'c', 1 << 5, 2}), 6), "abcabc");
}

TEST(Lzf, ACopyMayOverlapItself) {
  // One literal, then 9 + 7 + 2 bytes from one back, by the long form.
  EXPECT_EQ(unpack_lzf(bytes({0, 'x', 7 << 5, 9, 0}), 19), std::string(19, 'x'));
}

TEST(Lzf, UsesTheHighBitsOfTheDistance) {
  std::string packed, plain;
  for (int i = 0; i < 300; ++i) {
    packed += bytes({0, i % 251});
    plain += bytes({i % 251});
  }
  packed += bytes({(1 << 5) | (299 >> 8), 299 & 255});
  EXPECT_EQ(unpack_lzf(packed, 303), plain + plain.substr(0, 3));
}

TEST(Lzf, RefusesWhatReachesOutsideInputOrOutput) {
  EXPECT_FALSE(unpack_lzf(bytes({5, 'a', 'b'}), 6)) << "literals cut off";
  EXPECT_FALSE(unpack_lzf(bytes({0, 'a', 1 << 5}), 4)) << "distance cut off";
  EXPECT_FALSE(unpack_lzf(bytes({0, 'a', 7 << 5, 1}), 11)) << "long form cut off";
  EXPECT_FALSE(unpack_lzf(bytes({0, 'a', 1 << 5, 1}), 4)) << "before the start";
  EXPECT_FALSE(unpack_lzf(bytes({1, 'a', 'b'}), 1)) << "more than announced";
  EXPECT_FALSE(unpack_lzf(bytes({1, 'a', 'b'}), 3)) << "less than announced";
  EXPECT_FALSE(unpack_lzf(bytes({0, 'a'}), std::size_t{1} << 40)) << "a size no stream can have";
}

TEST(Lzf, SurvivesNoise) {
  std::mt19937 random(7);
  for (int i = 0; i < 20000; ++i) {
    std::string noise;
    for (auto n = random() % 40; n > 0; --n) noise.push_back(static_cast<char>(random()));
    const std::size_t size = random() % 300;
    const auto out = unpack_lzf(noise, size);
    EXPECT_EQ(out.value_or(std::string(size, 'x')).size(), size);
  }
}

}  // namespace
}  // namespace enfilade::laser_3d
