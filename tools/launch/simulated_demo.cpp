// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include "interfaces/model/counted.hpp"
#include "interfaces/runtime/command_line.hpp"
#include "interfaces/topics/topics.hpp"
#include "tools/launch/demo.hpp"
#include "tools/launch/progress.hpp"
#include "tools/launch/session.hpp"
#include "tools/report/report.hpp"
#include "tools/simulator/world/load_world.hpp"

namespace enfilade::launch {
namespace {

constexpr double kMaxSimTime_s = 3600.0;

std::string status_line(const report::RunRecord& record) {
  const ExplorationState& state = record.exploration;
  return fmt::format("{:7.1f} s  {}, {:.0f} % of the walls unseen, {}, {}, {:.1f} m driven: {}",
                     seconds(record.ground_truth.stamp_ns), counted(state.sweeps_total, "sweep"),
                     100.0 * state.unexplored_wall_share, counted(record.map.rooms.size(), "room"),
                     counted(record.map.doors.size(), "door"), record.ground_truth.path_length_m,
                     state.activity);
}

/// Before it gives the time itself the simulator has the host's clock.
double simulated_s(StampNs stamp_ns) {
  constexpr double kHostClockFrom_s = 1e9;
  return seconds(stamp_ns) < kHostClockFrom_s ? seconds(stamp_ns) : 0.0;
}

/// Beside the shipped configuration.
std::string paper_world() {
  const std::filesystem::path etc = find_config_file("simulator", executable_path(), process_environment);
  return (etc.parent_path() / "worlds/paper_two_rooms.yaml").string();
}

Settings settings_of(const DemoOptions& options, const std::string& world, const std::string& out) {
  Settings settings = options.settings;
  settings.set("simulator", "world", world);
  settings.set("simulator", "speed", fmt::format("{}", options.speed));
  if (options.seed_given) settings.set("simulator", "seed", std::to_string(options.seed));
  settings.set("topoGraph", "map_file", out + "/map.yaml");
  settings.set("topoGraph", "resume", "true");  // for a restart within this run; the folder is new
  return settings;
}

int tell(SessionEnd end, const report::Report& report, const std::string& out) {
  if (end == SessionEnd::kMemberLost) {
    print_loss(out);
    std::cerr << fmt::format("enfilade demo: a component was lost; the logs are in {}/log\n", out);
    return 1;
  }
  report::write_files(report, out);
  std::cout << report::to_table(report) << fmt::format("  map, floor plan, scans and logs are in {}\n", out);
  if (end == SessionEnd::kDone && report.record.finished()) return 0;
  std::cerr << fmt::format(
      "enfilade demo: the exploration did not finish: {}\n",
      end == SessionEnd::kInterrupted ? "interrupted" : report.record.exploration.activity);
  return 1;
}

}  // namespace

int run_simulated_demo(const DemoOptions& options) {
  const std::string world =
      std::filesystem::absolute(options.world.empty() ? paper_world() : options.world).string();
  const simulator::WorldTruth truth = simulator::load_world(world).truth;
  const std::string out = prepare_out_folder(options);
  const int domain = resolve_domain(options.domain, process_environment);
  const std::vector<std::string> components(kComponents.begin(), kComponents.end());
  Progress progress;
  const auto begin = std::chrono::steady_clock::now();
  Session session(
      deployment_of(components, settings_of(options, world, out), domain, true, out), domain,
      [&progress](const std::string& text) { progress.line("            enfilade     " + text); });
  report::RunRecorder recorder(session.bus(), truth.T_world_start);
  session.bus().subscribe<LogLine>(topics::kRosout, [&](const LogLine& line) {
    progress.line(
        fmt::format("{:7.1f} s  {:<12} {}", simulated_s(line.stamp_ns), line.component_name, line.text));
  });
  const SessionEnd end = session.run([&] {
    progress.status(status_line(recorder.record()));
    return recorder.record().ended() || seconds(recorder.record().ground_truth.stamp_ns) > kMaxSimTime_s;
  });
  progress.status("");
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  return tell(
      end,
      report::make_report(recorder.record(), truth, std::filesystem::path(world).filename(), wall.count()),
      out);
}

}  // namespace enfilade::launch
