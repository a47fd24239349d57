// SPDX-License-Identifier: Apache-2.0
// count_clouds DOMAIN shm|udp COUNT: reads rt/points as gridBuilder and ends with 0 once COUNT clouds have
// come, stamped 1 to COUNT, in order and whole. Says what it has got otherwise.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <string>
#include <thread>

#include <unistd.h>

#include "interfaces/dds/dds_bus.hpp"
#include "interfaces/runtime/thread_executor.hpp"
#include "interfaces/topics/topics.hpp"

namespace {

struct StderrLog : enfilade::Log {
  void debug(std::string_view) override {}
  void info(std::string_view) override {}
  void warn(std::string_view text) override {
    std::fprintf(stderr, "%.*s\n", static_cast<int>(text.size()), text.data());
  }
  void error(std::string_view text) override { warn(text); }
};

bool is_whole(const enfilade::PointCloud& cloud) {
  const auto stamp = static_cast<float>(cloud.stamp_ns);
  for (const enfilade::Point3f& point : cloud.points) {
    if (point.x_m != stamp || point.z_m != -stamp) return false;
  }
  return !cloud.points.empty();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const int count = std::stoi(argv[3]);
  StderrLog log;
  enfilade::ThreadExecutor executor;
  std::atomic<int> got = 0, wrong = 0;
  {
    enfilade::DdsBus bus("gridBuilder",
                         {.domain = std::stoi(argv[1]), .shared_memory = std::string(argv[2]) == "shm"},
                         executor, log);
    bus.subscribe<enfilade::PointCloud>(enfilade::topics::kPoints, [&](const enfilade::PointCloud& cloud) {
      ++got;
      if (cloud.stamp_ns != got || !is_whole(cloud)) ++wrong;
    });
    executor.start();
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (got < count && wrong == 0 && std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  executor.stop();
  if (got != count || wrong != 0) {
    std::fprintf(stderr, "%d of %d clouds, %d wrong or out of order\n", got.load(), count, wrong.load());
    return 1;
  }
  return 0;
}
