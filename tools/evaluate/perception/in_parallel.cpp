// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/perception/in_parallel.hpp"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace enfilade::evaluate {

void in_parallel(int count, const std::function<void(int)>& work) {
  std::atomic<int> next = 0;
  const auto work_on = [&] {
    for (int i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::future<void>> workers;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
    workers.push_back(std::async(std::launch::async, work_on));
  for (auto& worker : workers) worker.get();
}

}  // namespace enfilade::evaluate
