// SPDX-License-Identifier: Apache-2.0
#include "tools/enfilade/composed_run.hpp"

#include <chrono>
#include <filesystem>

#include "components/explorer/node/explorer_config.hpp"
#include "components/explorer/node/explorer_node.hpp"
#include "components/gridBuilder/node/grid_builder_config.hpp"
#include "components/gridBuilder/node/grid_builder_node.hpp"
#include "components/laser3D/node/laser_3d_config.hpp"
#include "components/laser3D/node/laser_3d_node.hpp"
#include "components/motorControl/node/motor_control_config.hpp"
#include "components/motorControl/node/motor_control_node.hpp"
#include "components/roomDetector/node/room_detector_config.hpp"
#include "components/roomDetector/node/room_detector_node.hpp"
#include "components/topoGraph/node/topo_graph_config.hpp"
#include "components/topoGraph/node/topo_graph_node.hpp"
#include "interfaces/convert/wire_codec.hpp"
#include "interfaces/runtime/command_line.hpp"
#include "interfaces/runtime/composed_system.hpp"
#include "tools/simulator/node/simulator_config.hpp"
#include "tools/simulator/node/simulator_node.hpp"
#include "tools/simulator/world/load_world.hpp"

namespace enfilade {
namespace {

template <class NodeType, class Config>
void add(ComposedSystem& system, const std::string& name, const Settings& settings) {
  const auto config =
      load_config<Config>(find_config_file(name, executable_path(), process_environment), settings.of(name));
  system.add(name, config.period,
             [config](const NodeContext& context) { return std::make_unique<NodeType>(context, config); });
}

void add_all(ComposedSystem& system, const Settings& settings) {
  add<simulator::SimulatorNode, simulator::SimulatorConfig>(system, "simulator", settings);
  add<motor_control::MotorControlNode, motor_control::MotorControlConfig>(system, "motorControl", settings);
  add<laser_3d::Laser3DNode, laser_3d::Laser3DConfig>(system, "laser3D", settings);
  add<grid_builder::GridBuilderNode, grid_builder::GridBuilderConfig>(system, "gridBuilder", settings);
  add<room_detector::RoomDetectorNode, room_detector::RoomDetectorNodeConfig>(system, "roomDetector",
                                                                              settings);
  add<topo_graph::TopoGraphNode, topo_graph::TopoGraphConfig>(system, "topoGraph", settings);
  add<explorer::ExplorerNode, explorer::ExplorerConfig>(system, "explorer", settings);
}

Settings settings_of(const ComposedRunOptions& options) {
  Settings settings = options.settings;
  settings.set("simulator", "world", std::filesystem::absolute(options.world).string());
  if (options.seed) settings.set("simulator", "seed", std::to_string(*options.seed));
  return settings;
}

}  // namespace

report::Report run_composed(const ComposedRunOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const simulator::WorldTruth truth = simulator::load_world(options.world).truth;
  ComposedConfig config{.log = options.log};
  if (options.through_wire) config.through_wire = wire::through_wire;
  ComposedSystem system(config);
  add_all(system, settings_of(options));
  report::RunRecorder recorder(system.tool_bus(), truth.T_world_start);
  system.run_until([&] { return recorder.record().ended(); }, from_seconds(options.max_sim_time_s));
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  return report::make_report(recorder.record(), truth, options.world, wall.count());
}

}  // namespace enfilade
