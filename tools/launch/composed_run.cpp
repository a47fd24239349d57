// SPDX-License-Identifier: Apache-2.0
#include "tools/launch/composed_run.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <functional>
#include <utility>

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
#include "interfaces/runtime/composed_system.hpp"
#include "tools/launch/component_config.hpp"
#include "tools/simulator/node/simulator_config.hpp"
#include "tools/simulator/node/simulator_node.hpp"
#include "tools/simulator/world/load_world.hpp"
#include "tools/support/scratch_folder.hpp"

namespace enfilade {
namespace {

/// Adds a component to `system`, if there is one; in any case its configuration is checked.
template <class NodeType, class Config>
void add(ComposedSystem* system, const std::string& name, const Settings& settings) {
  const auto config = load_component_config<Config>(name, settings);
  if (!system) return;
  system->add(name, config.period,
              [config](const NodeContext& context) { return std::make_unique<NodeType>(context, config); });
}

constexpr double kRestart_s = 1.0;

using AddComponent = std::function<void(ComposedSystem*, const std::string&, const Settings&)>;

/// In the order that breaks ties in time.
const std::vector<std::pair<std::string, AddComponent>>& components() {
  static const std::vector<std::pair<std::string, AddComponent>> all{
      {"simulator", add<simulator::SimulatorNode, simulator::SimulatorConfig>},
      {"motorControl", add<motor_control::MotorControlNode, motor_control::MotorControlConfig>},
      {"laser3D", add<laser_3d::Laser3DNode, laser_3d::Laser3DConfig>},
      {"gridBuilder", add<grid_builder::GridBuilderNode, grid_builder::GridBuilderConfig>},
      {"roomDetector", add<room_detector::RoomDetectorNode, room_detector::RoomDetectorNodeConfig>},
      {"topoGraph", add<topo_graph::TopoGraphNode, topo_graph::TopoGraphConfig>},
      {"explorer", add<explorer::ExplorerNode, explorer::ExplorerConfig>}};
  return all;
}

void add_component(ComposedSystem& system, const std::string& name, const Settings& settings) {
  for (const auto& [known, add_it] : components()) {
    if (known == name) add_it(&system, name, settings);
  }
}

/// Runs through the deaths that come before the end.
void run_with_kills(ComposedSystem& system, const ComposedRunOptions& options, const Settings& settings,
                    const std::function<bool()>& ended) {
  std::vector<Kill> kills = options.kills;
  std::stable_sort(kills.begin(), kills.end(), [](const Kill& a, const Kill& b) { return a.at_s < b.at_s; });
  for (const Kill& kill : kills) {
    if (system.run_until(ended, from_seconds(kill.at_s))) return;
    system.kill(kill.component);
    if (system.run_until(ended, from_seconds(kill.at_s + kRestart_s))) return;
    add_component(system, kill.component, settings);
  }
  system.run_until(ended, from_seconds(options.max_sim_time_s));
}

Settings settings_of(const ComposedRunOptions& options) {
  Settings settings = options.settings;
  settings.set("simulator", "world", std::filesystem::absolute(options.world).string());
  if (options.seed) settings.set("simulator", "seed", std::to_string(*options.seed));
  // On a virtual clock nobody waits for an estimate: one a period does, for a quarter of the work.
  settings.set_default("roomDetector", "every_line", "false");
  return settings;
}

/// Whether topoGraph dies and has nothing to come back from.
bool kills_map_keeper(const ComposedRunOptions& options) {
  const ConfigOverrides& overrides = options.settings.of("topoGraph");
  const bool dies = std::any_of(options.kills.begin(), options.kills.end(),
                                [](const Kill& kill) { return kill.component == "topoGraph"; });
  return dies && std::none_of(overrides.begin(), overrides.end(),
                              [](const std::string& o) { return o.starts_with("map_file="); });
}

void keep_map_in(const std::filesystem::path& folder, Settings& settings) {
  settings.set("topoGraph", "map_file", folder / "map.yaml");
  settings.set("topoGraph", "resume", "true");
}

}  // namespace

Kill parse_kill(const std::string& text) {
  const std::size_t at = text.find('@');
  const std::string name = text.substr(0, at);
  const bool known =
      name != "simulator" && std::any_of(components().begin(), components().end(),
                                         [&](const auto& entry) { return entry.first == name; });
  double at_s = 0.0;
  const char* const begin = at == std::string::npos ? nullptr : text.data() + at + 1;
  const char* const end = text.data() + text.size();
  const bool number =
      begin && std::from_chars(begin, end, at_s).ptr == end && begin != end && at_s >= 0.0 && at_s <= 1e9;
  if (!known || !number) {
    throw ConfigError("--kill " + text +
                      ": give COMPONENT@SECONDS with one of the six components, e.g. explorer@90");
  }
  return {name, at_s};
}

void check_settings(const Settings& settings) {
  for (const auto& [name, add_it] : components()) add_it(nullptr, name, settings);
}

report::Report run_composed(const ComposedRunOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const simulator::WorldTruth truth = simulator::load_world(options.world).truth;
  ComposedConfig config{.log = options.log};
  if (options.through_wire) config.through_wire = wire::through_wire;
  Settings settings = settings_of(options);
  std::optional<ScratchFolder> scratch;
  if (kills_map_keeper(options)) keep_map_in(scratch.emplace().path(), settings);
  ComposedSystem system(config);
  for (const auto& [name, add_it] : components()) add_it(&system, name, settings);
  report::RunRecorder recorder(system.tool_bus(), truth.T_world_start);
  run_with_kills(system, options, settings, [&] { return recorder.record().ended(); });
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  return report::make_report(recorder.record(), truth, options.world, wall.count());
}

}  // namespace enfilade
