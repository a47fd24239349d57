// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace enfilade {

/// A few threads that work lists of short tasks off together with their caller.
///
/// The next list often follows within microseconds: they wait busily for a moment before they sleep.
class Crew {
 public:
  using Work = std::function<void(int task, int worker)>;

  /// `size` workers, of which the caller of run() is one; no more than there are processors.
  explicit Crew(int size);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  int size() const { return static_cast<int>(threads_.size()) + 1; }
  /// Calls work(task, worker) once for each 0 ≤ task < tasks, at most 65,535, in order of their beginning,
  /// and returns when all are done. Of the tasks that are at work at the same time each has another 0 ≤
  /// worker < size(). One caller at a time; `work` must not throw.
  void run(int tasks, const Work& work);

 private:
  /// The task to be taken next. With the number of its list, so that who comes late takes none of another.
  struct Next {
    std::uint32_t list;
    std::uint16_t tasks, task;
  };

  void follow(int worker);
  void work_off(std::uint32_t list, int worker);

  const Work* work_ = nullptr;
  std::atomic<Next> next_{Next{}};
  std::atomic<int> open_{0};
  std::atomic<std::uint32_t> list_{0};
  std::atomic<bool> ends_{false};
  std::vector<std::thread> threads_;
};

}  // namespace enfilade
