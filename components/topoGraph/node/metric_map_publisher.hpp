// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "components/topoGraph/metric_map/occupancy_grid.hpp"
#include "interfaces/runtime/node.hpp"
#include "interfaces/topics/topics.hpp"

namespace enfilade::topo_graph {

struct MetricMapPublisherConfig {
  double resolution_m = 0.05;  ///< of rt/map; 0 = it is not drawn
  int max_cells = 4'000'000;   ///< a larger map gets cells of twice the side, until it fits
};

/// Keeps rt/map up to date: drawn once for each version of the graph, and only when somebody reads it.
class MetricMapPublisher {
 public:
  MetricMapPublisher(const NodeContext& context, const MetricMapPublisherConfig& config);

  void open();
  void update(const TopologicalMap& map);

 private:
  void warn_once(const std::string& text);

  NodeContext context_;
  MetricMapPublisherConfig config_;
  Publisher<OccupancyMap> map_;
  std::optional<std::uint64_t> drawn_version_;
  bool warned_ = false;
};

}  // namespace enfilade::topo_graph
