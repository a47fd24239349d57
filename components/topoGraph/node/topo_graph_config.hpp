// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "components/topoGraph/core/topo_graph.hpp"
#include "components/topoGraph/node/metric_map_publisher.hpp"
#include "interfaces/runtime/config.hpp"

namespace enfilade::topo_graph {

struct TopoGraphConfig {
  PeriodConfig period{.compute_s = 0.05};  ///< of tf map → odom
  std::string map_file;                    ///< where map and session are kept; "" = nowhere
  int journal_kib = 64;                    ///< the journal is folded into map_file when larger than both
  bool resume = false;                     ///< go on with the session in map_file, where there is one
  double estimate_period_s = 0.25;         ///< room estimates are looked at so often
  bool locate = false;                     ///< with resume: the robot may stand anywhere in the map
  MetricMapPublisherConfig metric_map;
  GraphConfig graph;
};

void bind(ConfigBinder& c, TopoGraphConfig& config);

}  // namespace enfilade::topo_graph
