// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/node/cloud_replay.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "components/laser3D/node/laser_3d_node.hpp"
#include "tests/support/node_harness.hpp"
#include "tests/unit/components/laser3D/pcd_text.hpp"
#include "tests/unit/components/laser3D/synthetic_room.hpp"

namespace enfilade::laser_3d {
namespace {

/// A file that lives as long as the test.
struct TemporaryFile {
  std::string name;

  TemporaryFile(const std::string& bytes, const std::string& ending) {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    name = testing::TempDir() + test + "." + std::to_string(getpid()) + "." + ending;
    std::ofstream(name, std::ios::binary) << bytes;
  }
  ~TemporaryFile() { std::filesystem::remove(name); }
};

Laser3DConfig replay_of(const std::string& file) {
  Laser3DConfig config;
  config.driver = DriverKind::kReplay;
  config.replay.file = file;
  return config;
}

using Harness = NodeHarness<Laser3DNode, Laser3DConfig>;

TEST(CloudReplay, PlaysEveryPointInLinesTwentyFiveMillisecondsApart) {
  const std::vector<Point3f> room = synthetic_room(1.3);
  const TemporaryFile file(compressed_pcd(room), "room.pcd");
  Harness harness("laser3D", replay_of(file.name));
  auto& lines = harness.collect(topics::kPoints);
  auto& tf_static = harness.collect(topics::kTfStatic);
  harness.advance_s(2.0);

  const auto expected = make_replay_cloud({}, {.points = room, .origin = {}});
  ASSERT_EQ(lines.size(), expected->lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].stamp_ns, static_cast<StampNs>(i + 1) * 25'000'000);
    EXPECT_EQ(lines[i].points, expected->lines[i]);
  }
  ASSERT_EQ(tf_static.size(), 1u);
  EXPECT_NEAR(tf_static[0].transforms[0].transform.z_m, 1.3, 0.01);
  EXPECT_EQ(harness.logged().back().text, "replay finished: " + std::to_string(expected->points) +
                                              " points in " + std::to_string(lines.size()) + " lines");
}

TEST(CloudReplay, WaitsForAReaderButNotForEver) {
  const TemporaryFile file(binary_pcd(synthetic_room(1.3)), "room.pcd");
  Harness harness("laser3D", replay_of(file.name));
  harness.advance_s(4.9);
  auto& lines = harness.collect(topics::kPoints);
  EXPECT_TRUE(lines.empty());
  harness.advance_s(0.1);
  EXPECT_FALSE(lines.empty()) << "a reader came";

  Harness alone("laser3D", replay_of(file.name));
  alone.advance_s(8.0);
  EXPECT_EQ(alone.logged().back().text.find("replay finished"), 0u);
}

TEST(CloudReplay, AFileThatCannotBeUsedEndsTheStartWithOneSentence) {
  const std::string whole = binary_pcd(synthetic_room(1.3));
  const TemporaryFile cut_off(whole.substr(0, whole.size() / 2), "cut_off.pcd");
  const TemporaryFile without_floor(binary_pcd({{1.0f, 1.0f, 1.0f}}), "without_floor.pcd");
  for (const std::string& name :
       {cut_off.name, without_floor.name, std::string("/nowhere/at/all.pcd"), std::string()}) {
    Harness harness("laser3D", replay_of(name));
    EXPECT_THROW(harness.node(), std::runtime_error) << name;
  }
}

}  // namespace
}  // namespace enfilade::laser_3d
