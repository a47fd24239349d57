// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/node/metric_map_publisher.hpp"

#include <exception>
#include <string>
#include <utility>

#include "components/topoGraph/metric_map/occupancy_message.hpp"

namespace enfilade::topo_graph {

MetricMapPublisher::MetricMapPublisher(const NodeContext& context, const MetricMapPublisherConfig& config)
    : context_(context), config_(config) {}

void MetricMapPublisher::open() {
  if (config_.resolution_m > 0.0) map_ = context_.bus.advertise(topics::kMap);
}

void MetricMapPublisher::update(const TopologicalMap& map) {
  if (config_.resolution_m <= 0.0 || map.rooms.empty() || drawn_version_ == map.version) return;
  if (map_.matched_readers() == 0) return;
  drawn_version_ = map.version;
  try {
    MetricMapConfig drawing{.resolution_m = config_.resolution_m};
    drawing.resolution_m = resolution_within(map, drawing, static_cast<std::size_t>(config_.max_cells));
    if (drawing.resolution_m > config_.resolution_m)
      warn_once("rt/map has cells of " + std::to_string(drawing.resolution_m) +
                " m: finer ones would be more than metric_map.max_cells");
    map_.publish(to_message(draw_metric_map(map, drawing), context_.clock.now_ns()));
  } catch (const std::invalid_argument& error) {
    warn_once(std::string("rt/map cannot be drawn: ") + error.what());
  }
}

void MetricMapPublisher::warn_once(const std::string& text) {
  if (!std::exchange(warned_, true)) context_.log.warn(text);
}

}  // namespace enfilade::topo_graph
