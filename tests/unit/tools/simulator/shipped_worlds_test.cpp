// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/etc_folder.hpp"
#include "tests/unit/tools/simulator/test_worlds.hpp"
#include "tools/simulator/world/load_world.hpp"

namespace enfilade::simulator {
namespace {

namespace fs = std::filesystem;

const fs::path kWorlds = fs::path(enfilade::test::etc_folder()) / "worlds";

std::vector<std::string> shipped() {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(kWorlds))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path().string());
  std::ranges::sort(files);
  return files;
}

/// Walks a grid of robot places from `from`; true where it comes within 0.1 m of `to`. The hull keeps
/// `margin_m` off everything.
bool can_drive(const World& world, const Point2& from, const Point2& to, double margin_m) {
  BodyConfig wide;
  wide.radius_m += margin_m;
  const Body body(wide, world);
  constexpr double kCell_m = 0.05;
  constexpr int kHalf = 300;
  std::vector<bool> seen(4 * kHalf * kHalf, false);
  std::vector<std::pair<int, int>> open{{0, 0}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (std::abs(i) >= kHalf || std::abs(j) >= kHalf) continue;
    const std::size_t index = static_cast<std::size_t>(i + kHalf) * 2 * kHalf + (j + kHalf);
    const Point2 place = from + kCell_m * Point2(i, j);
    if (seen[index] || (place - from).norm() > (to - from).norm() + 3.0 || !body.fits(place)) continue;
    if ((place - to).norm() < 0.1) return true;
    seen[index] = true;
    for (const auto& [di, dj] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
      open.emplace_back(i + di, j + dj);
  }
  return false;
}

TEST(ShippedWorlds, ParseAndHaveAFreeStartInsideARoom) {
  ASSERT_GE(shipped().size(), 4u);
  for (const std::string& file : shipped()) {
    const World world = load_world(file);
    EXPECT_NO_THROW(Simulation(world, SimulationConfig{})) << file;
    const Point2 start = world.truth.T_world_start.translation();
    EXPECT_TRUE(std::ranges::any_of(world.truth.rooms, [&](const TrueRoom& r) {
      return r.rectangle.contains(start, 0.22);
    })) << file;
  }
}

TEST(ShippedWorlds, LeaveTheRobotRoomToEveryDoorAndRoom) {
  for (const std::string& file : shipped()) {
    const World world = load_world(file);
    const Point2 start = world.truth.T_world_start.translation();
    for (const TrueDoor& door : world.truth.doors)
      EXPECT_TRUE(can_drive(world, start, door.opening.midpoint(), 0.08)) << file << " " << door.name;
    for (const TrueRoom& room : world.truth.rooms)
      EXPECT_TRUE(can_drive(world, start, room.rectangle.pose().translation(), 0.08))
          << file << " " << room.name;
  }
}

TEST(ShippedWorlds, ThePapersRoomsHaveThePapersSizes) {
  const WorldTruth truth = load_world((kWorlds / "paper_two_rooms.yaml").string()).truth;
  ASSERT_EQ(truth.rooms.size(), 2u);
  EXPECT_DOUBLE_EQ(truth.rooms[0].rectangle.width_m, 3.19);
  EXPECT_DOUBLE_EQ(truth.rooms[0].rectangle.height_m, 3.78);
  EXPECT_DOUBLE_EQ(truth.rooms[1].rectangle.width_m, 4.20);
  EXPECT_DOUBLE_EQ(truth.rooms[1].rectangle.height_m, 3.78);
  EXPECT_NEAR(truth.rooms[0].rectangle.yaw_rad, radians(7.0), 1e-12);
  ASSERT_EQ(truth.doors.size(), 2u);
  EXPECT_TRUE(truth.doors[0].other);
  EXPECT_FALSE(truth.doors[1].other);
  for (const TrueDoor& door : truth.doors) EXPECT_NEAR(door.opening.length(), 0.90, 1e-9);
}

}  // namespace
}  // namespace enfilade::simulator
