// SPDX-License-Identifier: Apache-2.0
#include "tools/support/files.hpp"

#include <filesystem>
#include <stdexcept>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "interfaces/runtime/read_file.hpp"
#include "tools/support/scratch_folder.hpp"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

TEST(WriteFile, ReplacesAFileAndLeavesNothingBeside) {
  const ScratchFolder scratch;
  const std::string path = scratch.path() / "a.json";
  write_file(path, "a longer text");
  write_file(path, "short");
  EXPECT_EQ(read_file(path), "short");
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path()), {}), 1);
}

TEST(WriteFile, WritesIntoAPipeAndLeavesItThere) {
  const ScratchFolder scratch;
  const std::string path = scratch.path() / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const int reader = open(path.c_str(), O_RDONLY | O_NONBLOCK);
  EXPECT_EQ(why_no_file(path), "");
  write_file(path, "text");
  char got[8] = {};
  EXPECT_EQ(read(reader, got, sizeof got), 4);
  EXPECT_STREQ(got, "text");
  EXPECT_TRUE(fs::is_fifo(path));
  close(reader);
}

TEST(WriteFile, NamesWhatCannotBeWritten) {
  const ScratchFolder scratch;
  for (const std::string path : {scratch.path() / "none/a.json", scratch.path()}) {
    EXPECT_NE(why_no_file(path).find(path), std::string::npos);
    EXPECT_THROW(write_file(path, "text"), std::runtime_error);
  }
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

}  // namespace
}  // namespace enfilade
