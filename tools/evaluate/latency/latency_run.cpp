// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/latency/latency_run.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "interfaces/geometry/angles.hpp"
#include "interfaces/topics/topics.hpp"
#include "tools/launch/demo.hpp"
#include "tools/launch/session.hpp"
#include "tools/support/scratch_folder.hpp"

namespace enfilade::evaluate {
namespace {

constexpr double kLineRate_hz = 40.0;
constexpr double kPatience_s = 60.0;  // for the first estimate

ArrivalNs wall_now_ns() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

StampNs end_of(const LaserScan& scan) {
  const double beams = scan.ranges_m.empty() ? 0.0 : static_cast<double>(scan.ranges_m.size() - 1);
  return scan.stamp_ns + from_seconds(beams * static_cast<double>(scan.time_increment_s));
}

/// Asks for one sweep after the other.
class Sweeps {
 public:
  Sweeps(int domain, double step_deg)
      : log_("explorer", clock_, [](const LogLine&) {}),
        bus_("explorer", deployed_dds_config(domain), executor_, log_),
        command_{.action = SweepAction::kSweep,
                 .from_rad = radians(-90.0),
                 .to_rad = radians(90.0),
                 .speed_rad_s = radians(step_deg) * kLineRate_hz},
        publisher_(bus_.advertise(topics::kSweepCommand)) {}

  void take(const MotorState& motor) {
    const bool is_done = motor.sweep_id == command_.sweep_id && motor.phase == SweepPhase::kDone;
    if (command_.sweep_id != 0 && !is_done) return;
    command_.sweep_id = std::max(command_.sweep_id, motor.sweep_id) + 1;
    publisher_.publish(command_);
  }

 private:
  SystemClock clock_;
  ComponentLog log_;
  ThreadExecutor executor_;  // never started: nothing is read
  DdsBus bus_;
  SweepCommand command_;
  Publisher<SweepCommand> publisher_;
};

void listen(Bus& bus, LatencyRecording& recording) {
  bus.subscribe<LaserScan>(topics::kScan, [&](const LaserScan& scan) {
    recording.scans.push_back({scan.stamp_ns, end_of(scan)});
  });
  bus.subscribe<JointStates>(topics::kJointStates, [&](const JointStates& joints) {
    recording.joints.push_back({joints.stamp_ns, wall_now_ns()});
  });
  bus.subscribe<PointCloud>(topics::kPoints, [&](const PointCloud& points) {
    recording.points.push_back({points.stamp_ns, wall_now_ns()});
  });
  bus.subscribe<GridChange>(topics::kGridChange, [&](const GridChange& change) {
    if (change.sequence > 0) recording.changes.push_back({change.stamp_ns, wall_now_ns()});
  });
  bus.subscribe<RoomEstimate>(topics::kRoomEstimate, [&](const RoomEstimate& estimate) {
    recording.estimates.push_back({estimate.stamp_ns, wall_now_ns()});
  });
}

launch::DeploymentConfig deployment(const LatencyRunConfig& config, const std::string& folder) {
  Settings settings = config.settings;
  settings.set("simulator", "world", std::filesystem::absolute(config.world).string());
  std::filesystem::create_directories(folder + "/log");
  return launch::deployment_of(
      {"simulator", "motorControl", "laser3D", "gridBuilder", "roomDetector", "topoGraph"}, settings,
      config.domain, true, folder);
}

}  // namespace

LatencyRecording record_latency(const LatencyRunConfig& config) {
  setenv("ENFILADE_SHARED_MEMORY", config.shared_memory ? "on" : "off", 1);
  const ScratchFolder scratch;
  LatencyRecording recording;
  launch::Session session(deployment(config, scratch.path()), config.domain, [](const std::string&) {});
  Sweeps sweeps(config.domain, config.step_deg);
  listen(session.bus(), recording);
  session.bus().subscribe<MotorState>(topics::kMotorState,
                                      [&sweeps](const MotorState& motor) { sweeps.take(motor); });
  const ArrivalNs begun_ns = wall_now_ns();
  const auto end = session.run([&] {
    const bool found = !recording.estimates.empty();
    const ArrivalNs since_ns = found ? recording.estimates.front().at_ns : begun_ns;
    return seconds(wall_now_ns() - since_ns) > (found ? config.seconds : kPatience_s);
  });
  if (end == launch::SessionEnd::kMemberLost) {
    launch::print_loss(scratch.path());
    throw std::runtime_error("a component was lost");
  }
  if (end == launch::SessionEnd::kInterrupted) throw std::runtime_error("interrupted");
  if (recording.estimates.empty())
    throw std::runtime_error("no room estimate came within a minute; is the DDS domain used by others?");
  return recording;
}

}  // namespace enfilade::evaluate
