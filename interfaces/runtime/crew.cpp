// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/crew.hpp"

#include <algorithm>

namespace enfilade {
namespace {

constexpr int kPatience = 4'000;  // looks before a worker sleeps: some 100 µs

void breathe() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#else
  std::this_thread::yield();
#endif
}

}  // namespace

Crew::Crew(int size) {
  const int processors = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  for (int worker = 1; worker < std::min(size, processors); ++worker)
    threads_.emplace_back([this, worker] { follow(worker); });
}

Crew::~Crew() {
  ends_ = true;
  ++list_;
  list_.notify_all();
  for (auto& thread : threads_) thread.join();
}

void Crew::run(int tasks, const Work& work) {
  const std::uint32_t list = list_ + 1;
  work_ = &work;
  open_ = tasks;
  next_ = Next{list, static_cast<std::uint16_t>(tasks), 0};
  list_ = list;
  list_.notify_all();
  work_off(list, 0);
  while (open_ > 0) breathe();
}

void Crew::follow(int worker) {
  std::uint32_t done = 0;
  while (true) {
    for (int i = 0; i < kPatience && list_ == done; ++i) breathe();
    list_.wait(done);
    done = list_;
    if (ends_) return;
    work_off(done, worker);
  }
}

void Crew::work_off(std::uint32_t list, int worker) {
  Next next = next_;
  while (next.list == list && next.task < next.tasks) {
    const Next after{list, next.tasks, static_cast<std::uint16_t>(next.task + 1)};
    if (!next_.compare_exchange_weak(next, after)) continue;
    (*work_)(next.task, worker);
    --open_;
    next = next_;
  }
}

}  // namespace enfilade
