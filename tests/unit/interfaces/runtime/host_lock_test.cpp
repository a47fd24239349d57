// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/host_lock.hpp"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include <gtest/gtest.h>
#include <unistd.h>

namespace enfilade {
namespace {

struct HostLockTest : testing::Test {
  void SetUp() override { std::filesystem::create_directories(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }
  std::string folder = testing::TempDir() + "enfilade_lock_" + std::to_string(getpid());
};

TEST_F(HostLockTest, TheSecondInstanceIsToldWhoHoldsIt) {
  const HostLock first(folder, "explorer", 3);
  try {
    const HostLock second(folder, "explorer", 3);
    FAIL() << "two instances";
  } catch (const std::runtime_error& e) {
    EXPECT_EQ(std::string(e.what()),
              "process " + std::to_string(getpid()) +
                  " already runs explorer in domain 3 on this host, stop it first or choose "
                  "another --domain");
  }
}

TEST_F(HostLockTest, OtherComponentsAndDomainsAreFree) {
  const HostLock first(folder, "explorer", 3);
  EXPECT_NO_THROW(HostLock(folder, "explorer", 4));
  EXPECT_NO_THROW(HostLock(folder, "topoGraph", 3));
}

TEST_F(HostLockTest, IsFreeAgainAndLeavesNoFileBehind) {
  { const HostLock first(folder, "explorer", 3); }
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  EXPECT_NO_THROW(HostLock(folder, "explorer", 3));
}

TEST_F(HostLockTest, AFolderThatCannotBeWrittenIsNamed) {
  try {
    const HostLock lock(folder + "/none", "explorer", 3);
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find(folder + "/none/explorer-3.lock"), std::string::npos) << e.what();
  }
}

TEST_F(HostLockTest, TheRuntimeFolderIsTheUsersOwn) {
  setenv("XDG_RUNTIME_DIR", folder.c_str(), 1);
  EXPECT_EQ(runtime_folder(), folder + "/enfilade");
  const auto mode = std::filesystem::status(folder + "/enfilade").permissions();
  EXPECT_EQ(mode, std::filesystem::perms::owner_all);
  unsetenv("XDG_RUNTIME_DIR");
  EXPECT_EQ(runtime_folder(), "/tmp/enfilade-" + std::to_string(geteuid()));
}

}  // namespace
}  // namespace enfilade
