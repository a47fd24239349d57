// SPDX-License-Identifier: Apache-2.0
#include "tests/integration/dds/dds_fixture.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <unistd.h>

namespace enfilade::test {

namespace {

/// Before any test: what other processes do in /dev/shm is not seen, and nothing is left behind there.
class PrivateSharedMemory : public testing::Environment {
 public:
  void SetUp() override {
    if (!make_private_shared_memory(std::size_t{512} << 20))
      std::puts("note: sharing /dev/shm with the host");
  }
};

[[maybe_unused]] const auto* const kEnvironment = testing::AddGlobalTestEnvironment(new PrivateSharedMemory);

}  // namespace

int own_domain() { return 100 + getpid() % 100; }

bool make_private_shared_memory(std::size_t bytes) {
  const std::string size = "size=" + std::to_string(bytes);
  return unshare(CLONE_NEWNS) == 0 && mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
         mount("tmpfs", "/dev/shm", "tmpfs", 0, size.c_str()) == 0;
}

bool eventually(const std::function<bool()>& condition, double seconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

void RecordingLog::warn(std::string_view text) {
  const std::lock_guard lock(mutex_);
  lines_.emplace_back(text);
}

int RecordingLog::count(const std::string& part) const {
  const std::lock_guard lock(mutex_);
  return static_cast<int>(std::ranges::count_if(
      lines_, [&part](const std::string& line) { return line.find(part) != std::string::npos; }));
}

Peer::Peer(const std::string& component, DdsConfig config) {
  executor.start();
  bus = std::make_unique<DdsBus>(component, config, executor, log);
}

Peer::~Peer() {
  bus.reset();
  executor.stop();
}

DdsConfig own_config() { return {.domain = own_domain()}; }

}  // namespace enfilade::test
