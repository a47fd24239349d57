// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/node/grid_follower.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace enfilade::room_detector {
namespace {

GridChange change(std::uint64_t sequence, double resolution_m = 0.05) {
  return {.tag = {1, 1, 1}, .sequence = sequence, .resolution_m = resolution_m};
}

struct GridFollowerTest : ::testing::Test {
  std::vector<std::uint64_t> applied, adopted;
  int asked = 0;
  GridFollower follower{{.start = [](const GridChange&) {},
                         .apply = [this](const GridChange& c) { applied.push_back(c.sequence); },
                         .adopt = [this](const GridChange& c) { adopted.push_back(c.sequence); },
                         .ask_for_snapshot = [this] { ++asked; }}};
};

TEST_F(GridFollowerTest, AppliesWhatItHeldBackAfterTheSnapshot) {
  for (const std::uint64_t sequence : {5, 6, 7}) follower.take_change(change(sequence));
  follower.take_snapshot(change(6));
  EXPECT_EQ(adopted, (std::vector<std::uint64_t>{6}));
  EXPECT_EQ(applied, (std::vector<std::uint64_t>{7}));
}

TEST_F(GridFollowerTest, AsksAnewInsteadOfHoldingBackWithoutBound) {
  std::uint64_t sequence = 2;
  for (std::size_t i = 0; i < GridFollower::kMostHeldBack; ++i) follower.take_change(change(sequence++));
  EXPECT_EQ(asked, 1);
  follower.take_change(change(sequence++));
  EXPECT_EQ(asked, 2);
  follower.take_change(change(sequence));
  follower.take_snapshot(change(sequence - 1));
  EXPECT_EQ(asked, 2);
  EXPECT_EQ(adopted, (std::vector<std::uint64_t>{sequence - 1}));
  EXPECT_EQ(applied, (std::vector<std::uint64_t>{sequence}));
  EXPECT_FALSE(follower.is_waiting());
}

TEST_F(GridFollowerTest, AsksOnceMoreForASnapshotOlderThanWhatItDropped) {
  const std::uint64_t last = GridFollower::kMostHeldBack + 2;
  for (std::uint64_t sequence = 2; sequence <= last; ++sequence) follower.take_change(change(sequence));
  follower.take_snapshot(change(2));
  EXPECT_TRUE(follower.is_waiting());
  EXPECT_EQ(asked, 3);
  follower.take_snapshot(change(last));
  EXPECT_EQ(adopted.back(), last);
  EXPECT_FALSE(follower.is_waiting());
}

TEST_F(GridFollowerTest, RefusesGridsWithoutAResolution) {
  for (const double bad :
       {0.0, -0.05, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    follower.take_change(change(1, bad));
    follower.take_snapshot(change(1, bad));
  }
  EXPECT_TRUE(applied.empty() && adopted.empty());
  EXPECT_FALSE(follower.tag());
}

}  // namespace
}  // namespace enfilade::room_detector
