// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/roomDetector/core/task_runner.hpp"
#include "interfaces/runtime/crew.hpp"

namespace enfilade::bench {

/// As many threads as a deployed roomDetector has for one search.
inline room_detector::TaskRunner deployed_runner() {
  static Crew crew(2);
  return {.workers = crew.size(),
          .run = [](int tasks, const room_detector::TaskRunner::Work& work) { crew.run(tasks, work); }};
}

}  // namespace enfilade::bench
