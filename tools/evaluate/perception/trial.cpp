// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/perception/trial.hpp"

#include <cmath>

#include "tools/evaluate/perception/judge.hpp"
#include "tools/evaluate/perception/rolling_scanner.hpp"

namespace enfilade::evaluate {
namespace {

/// A stand of the robot: where it is, and where odometry has it.
struct Stand {
  Pose2 T_world_base, T_zone_base;
  bool in_room = true;
};

std::vector<Stand> stands_of(const RoomCase& room, const TrialConfig& config) {
  std::vector<Stand> stands;
  const auto turn = [](const Pose2& T, int quarters) { return T * Pose2{0.0, 0.0, 0.5 * kPi * quarters}; };
  for (int i = 0; i < config.neighbour_sweeps; ++i)
    stands.push_back({turn(room.T_world_neighbour, 2 * i), {}, false});
  for (int i = 0; i < config.sweeps; ++i) stands.push_back({turn(room.T_world_base, i), {}, true});
  simulator::Random random(config.seed + 77);
  for (std::size_t i = 1; i < stands.size(); ++i) {
    const Pose2 T_true = stands[i - 1].T_world_base.inverse() * stands[i].T_world_base;
    const Pose2 T_error{random.gauss(config.turn_sigma_m), random.gauss(config.turn_sigma_m),
                        random.gauss(radians(config.turn_sigma_deg))};
    stands[i].T_zone_base = stands[i - 1].T_zone_base * T_true * T_error;
  }
  return stands;
}

/// A detector that listens to the grid.
class Method {
 public:
  Method(const room_detector::RoomDetectorConfig& config, double resolution_m) : detector_(config) {
    detector_.clear(resolution_m);
  }
  void take(const ZoneRecorder::Line& line) {
    detector_.update(line.change);
    detector_.add_hits(line.hits);
  }
  /// Without a refinement nobody asks for the returns.
  void take_cells(const ZoneRecorder::Line& line) { detector_.update(line.change); }
  void look(const Pose2& T_zone_base, const Rectangle& truth) {
    estimate_ = detector_.estimate(T_zone_base).estimate;
    answer_.iou.push_back(estimate_.found ? iou(estimate_.rectangle, truth) : 0.0);
  }
  Answer finish(const Rectangle& truth, const std::vector<VisibleDoor>& doors) {
    if (!estimate_.found) return answer_;
    answer_.size_errors_m = size_errors_m(estimate_.rectangle, truth);
    answer_.nees = nees(estimate_, truth);
    if (answer_.is_right()) answer_.doors = judge_doors(estimate_, truth, doors);
    return answer_;
  }

 private:
  room_detector::RoomDetector detector_;
  RoomEstimate estimate_;
  Answer answer_;
};

/// The room's walls keep their names in every frame.
std::vector<VisibleDoor> doors_of(const RoomCase& room, const std::vector<Stand>& stands,
                                  const simulator::RayScene& scene) {
  std::vector<VisibleDoor> doors;
  for (const simulator::TrueDoor& door : room.doors) {
    std::vector<Pose2> from;
    for (const Stand& stand : stands)
      if (stand.in_room) from.push_back(stand.T_world_base);
    const WallInterval gap = gap_of(door.opening, room.room);
    doors.push_back({gap, visible_share(segment_of(room.room, gap), door.height_m, from, scene)});
  }
  return doors;
}

}  // namespace

void DoorTally::add(const DoorTally& other) {
  reported += other.reported;
  right += other.right;
  visible += other.visible;
  found += other.found;
  edge_errors_m.insert(edge_errors_m.end(), other.edge_errors_m.begin(), other.edge_errors_m.end());
}

room_detector::RoomDetectorConfig paper_config() {
  room_detector::RoomDetectorConfig config;
  config.votes.score = room_detector::Score::kPaper;
  config.band.band = room_detector::BandChoice::kAll;
  config.doors = room_detector::DoorMethod::kPaper;
  config.refine = false;
  return config;
}

TrialResult run_trial(const TrialConfig& config) {
  const RoomCase room = make_room_case(config.seed, config.hardship);
  const std::vector<Stand> stands = stands_of(room, config);
  RollingScannerConfig scanner_config{.line_step_deg = config.line_step_deg};
  scanner_config.laser.bias_m = config.range_bias_m;
  scanner_config.projector.range_bias_m = config.assumed_bias_m;
  RollingScanner scanner(room.world, scanner_config, config.seed);
  const Pose2 T_zone_world = stands.front().T_world_base.inverse();
  const Rectangle truth = T_zone_world * room.room;
  const auto doors = doors_of(room, stands, scanner.scene());

  const grid_builder::ZoneGridConfig grid;
  ZoneRecorder recorder(grid);
  Method paper(paper_config(), grid.resolution_m), evidence({}, grid.resolution_m);
  const laser_3d::ScanProjectorConfig& mount = scanner_config.projector;
  const Point3f origin_base{static_cast<float>(mount.mount_x_m), static_cast<float>(mount.mount_y_m),
                            static_cast<float>(mount.mount_z_m)};
  for (const Stand& stand : stands) {
    for (const auto& line : scanner.sweep(stand.T_world_base)) {
      const ZoneRecorder::Line recorded = recorder.insert(line, origin_base, stand.T_zone_base);
      if (config.with_paper) paper.take_cells(recorded);
      evidence.take(recorded);
    }
    if (!stand.in_room) continue;
    if (config.with_paper) paper.look(stand.T_zone_base, truth);
    evidence.look(stand.T_zone_base, truth);
  }
  return {paper.finish(truth, doors), evidence.finish(truth, doors)};
}

}  // namespace enfilade::evaluate
