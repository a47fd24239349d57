// SPDX-License-Identifier: Apache-2.0
#include "interfaces/dds/shared_memory.hpp"

#include <atomic>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

#include "interfaces/topics/topics.hpp"
#include "tests/integration/dds/child.hpp"
#include "tests/integration/dds/dds_fixture.hpp"

namespace enfilade {
namespace {

namespace fs = std::filesystem;
using test::Child;
using test::eventually;
using test::own_config;
using test::Peer;

std::size_t files_in_shared_memory() {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator("/dev/shm"), fs::directory_iterator()));
}

PointCloud cloud_of(StampNs stamp, std::size_t points) {
  const auto value = static_cast<float>(stamp);
  return {stamp, "base_link", std::vector<Point3f>(points, {value, 0, -value})};
}

constexpr std::size_t kPointsOfOneMegabyte = (std::size_t{1} << 20) / sizeof(Point3f);

/// Another process gets `count` clouds of 1 MB at the topic's rate.
void expect_all_clouds_cross(bool shared_memory, int count) {
  DdsConfig config = own_config();
  config.shared_memory = shared_memory;
  Peer writer("laser3D", config);
  EXPECT_EQ(writer.bus->uses_shared_memory(), shared_memory);
  const auto publisher = writer.bus->advertise(topics::kPoints);
  Child reader({ENFILADE_COUNT_CLOUDS, std::to_string(config.domain), shared_memory ? "shm" : "udp",
                std::to_string(count)});
  ASSERT_TRUE(eventually([&] { return publisher.matched_readers() == 1; }));
  for (int i = 1; i <= count; ++i) {
    publisher.publish(cloud_of(i, kPointsOfOneMegabyte));
    std::this_thread::sleep_for(std::chrono::duration<double>(1.0 / topics::kPoints.info.rate_hz));
  }
  EXPECT_EQ(reader.wait(), 0);
}

TEST(DdsBus, BringsAHundredOfAHundredLargeCloudsToAnotherProcess) { expect_all_clouds_cross(true, 100); }

TEST(DdsBus, BringsLargeCloudsToAnotherProcessOverUdpAlone) { expect_all_clouds_cross(false, 40); }

TEST(DdsBus, RunsOverUdpAloneAndSaysSoWhereSharedMemoryIsFull) {
  if (!test::make_private_shared_memory(std::size_t{1} << 20)) GTEST_SKIP() << "needs the right to mount";
  Peer writer("explorer", own_config()), reader("motorControl", own_config());
  EXPECT_FALSE(writer.bus->uses_shared_memory());
  EXPECT_TRUE(eventually([&] { return writer.log.count("UDP only") == 1; }));
  std::atomic<bool> arrived = false;
  reader.bus->subscribe<VelocityCommand>(topics::kCmdVel, [&](const VelocityCommand&) { arrived = true; });
  const auto publisher = writer.bus->advertise(topics::kCmdVel);
  ASSERT_TRUE(eventually([&] { return publisher.matched_readers() == 1; }));
  publisher.publish({});
  EXPECT_TRUE(eventually([&] { return arrived.load(); }));
  reader.bus.reset();
}

TEST(SharedMemory, IsNotToBeHadInAFolderThatDoesNotExist) {
  EXPECT_TRUE(why_no_shared_memory(1, "/nowhere").has_value());
  EXPECT_FALSE(why_no_shared_memory(4096, testing::TempDir()).has_value());
}

TEST(SharedMemory, HoldsNoFileOfOursAfterACleanEnd) {
  if (!test::make_private_shared_memory(std::size_t{256} << 20)) GTEST_SKIP() << "needs the right to mount";
  {
    Peer writer("explorer", own_config()), reader("motorControl", own_config());
    const auto publisher = writer.bus->advertise(topics::kCmdVel);
    reader.bus->subscribe<VelocityCommand>(topics::kCmdVel, [](const VelocityCommand&) {});
    ASSERT_TRUE(eventually([&] { return publisher.matched_readers() == 1; }));
    EXPECT_GT(files_in_shared_memory(), 0U);
  }
  EXPECT_EQ(files_in_shared_memory(), 0U);
}

std::vector<std::string> count_one_cloud() {
  return {ENFILADE_COUNT_CLOUDS, std::to_string(test::own_domain()), "shm", "1"};
}

TEST(SharedMemory, LosesAllThatKilledProcessesLeftBehindAndNoFileOfOthers) {
  if (!test::make_private_shared_memory(std::size_t{256} << 20)) GTEST_SKIP() << "needs the right to mount";
  std::ofstream("/dev/shm/not_ours") << "x";
  Child killed(count_one_cloud());
  ASSERT_TRUE(eventually([&] { return files_in_shared_memory() > 5; }));
  EXPECT_EQ(remove_stale_segments(), 0);
  killed.kill();
  killed.wait();
  EXPECT_GT(files_in_shared_memory(), 5U);
  EXPECT_GT(remove_stale_segments(), 5);
  EXPECT_EQ(files_in_shared_memory(), 1U);
  EXPECT_TRUE(fs::exists("/dev/shm/not_ours"));
}

TEST(SharedMemory, KeepsCarryingMessagesWhenLeftoversAreRemoved) {
  if (!test::make_private_shared_memory(std::size_t{256} << 20)) GTEST_SKIP() << "needs the right to mount";
  Peer writer("laser3D", own_config());
  const auto publisher = writer.bus->advertise(topics::kPoints);
  Child killed(count_one_cloud());
  ASSERT_TRUE(eventually([&] { return publisher.matched_readers() == 1; }));
  EXPECT_EQ(remove_stale_segments(), 0);
  killed.kill();
  ASSERT_TRUE(eventually([&] { return publisher.matched_readers() == 0; }));
  remove_stale_segments();

  Child next(count_one_cloud());
  ASSERT_TRUE(eventually([&] { return publisher.matched_readers() == 1; }));
  publisher.publish(cloud_of(1, 10));
  EXPECT_EQ(next.wait(), 0);
}

TEST(SharedMemory, IsLeftOutWhereTheEnvironmentSaysSo) {
  EXPECT_TRUE(deployed_dds_config(7).shared_memory);
  setenv("ENFILADE_SHARED_MEMORY", "off", 1);
  const DdsConfig config = deployed_dds_config(7);
  unsetenv("ENFILADE_SHARED_MEMORY");
  EXPECT_FALSE(config.shared_memory);
  EXPECT_EQ(config.domain, 7);
  Peer peer("laser3D", {.domain = test::own_domain(), .shared_memory = config.shared_memory});
  EXPECT_FALSE(peer.bus->uses_shared_memory());
}

}  // namespace
}  // namespace enfilade
