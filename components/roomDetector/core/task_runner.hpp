// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace enfilade::room_detector {

/// Who works lists of tasks off. By default the caller alone, in order; threads come from outside, since a
/// core has none.
struct TaskRunner {
  using Work = std::function<void(int task, int worker)>;

  int workers = 1;  ///< at a time
  /// Calls work(task, worker) once for each 0 ≤ task < tasks and returns when all are done. Of the tasks that
  /// are at work at the same time each has another 0 ≤ worker < workers.
  std::function<void(int tasks, const Work& work)> run = [](int tasks, const Work& work) {
    for (int task = 0; task < tasks; ++task) work(task, 0);
  };
};

}  // namespace enfilade::room_detector
