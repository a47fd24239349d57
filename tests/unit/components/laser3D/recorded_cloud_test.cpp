// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "components/laser3D/core/replay_cloud.hpp"

namespace enfilade::laser_3d {
namespace {

/// A recorded cloud of the folder that the environment variable ENFILADE_DATA names, if it is there.
std::optional<FileBytes> recorded(const std::string& file) {
  const char* folder = std::getenv("ENFILADE_DATA");
  if (folder == nullptr) return std::nullopt;
  const std::string name = std::string(folder) + "/clouds/" + file;
  std::ifstream in(name, std::ios::binary);
  if (!in) return std::nullopt;
  return FileBytes{name, {std::istreambuf_iterator<char>(in), {}}};
}

constexpr const char* kSkipped =
    "set ENFILADE_DATA to the folder that holds clouds/ to run this on recorded data";

TEST(RecordedCloud, RoomScanIsReadWholeAndItsFloorIsFound) {
  const auto file = recorded("room_scan1.pcd");
  if (!file) GTEST_SKIP() << kSkipped;
  const ScannedPoints scanned = read_points(*file);
  EXPECT_EQ(scanned.points.size(), 112'586u);
  const auto cloud = make_replay_cloud({}, scanned);
  ASSERT_TRUE(cloud);
  EXPECT_NEAR(cloud->scanner_height_m, 1.3, 0.05);
  RecordProperty("scanner_height_m", std::to_string(cloud->scanner_height_m));
  RecordProperty("tilt_rad", std::to_string(cloud->tilt_rad));
}

TEST(RecordedCloud, CorridorScansAreReadWithTheirFloorBelowTheScanner) {
  std::optional<double> height_m;
  for (const std::string name : {"scan000.3d", "scan001.3d", "scan002.3d"}) {
    const auto file = recorded(name);
    if (!file) GTEST_SKIP() << kSkipped;
    const auto cloud = make_replay_cloud({}, read_points(*file));
    ASSERT_TRUE(cloud);
    if (!height_m) height_m = cloud->scanner_height_m;
    EXPECT_NEAR(cloud->scanner_height_m, *height_m, 0.06) << "one scanner, one height, uneven ground";
    RecordProperty(name, std::to_string(cloud->scanner_height_m));
  }
}

}  // namespace
}  // namespace enfilade::laser_3d
