// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/evaluate/latency/latency.hpp"

namespace enfilade::evaluate {

struct LatencyReport {
  struct Part {
    std::string transport;  ///< "shared_memory" or "udp"
    LatencyFigures figures;
  };
  std::vector<Part> parts;
  double load = 0.0;  ///< processes that wanted a processor, mean over the last minute
  unsigned processors = 0;
};

std::string to_table(const LatencyReport& report);
std::string to_json(const LatencyReport& report);

}  // namespace enfilade::evaluate
