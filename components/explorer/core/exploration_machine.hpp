// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "components/explorer/core/door_crossing.hpp"
#include "components/explorer/core/door_geometry.hpp"
#include "components/explorer/core/door_judge.hpp"
#include "components/explorer/core/drive.hpp"
#include "components/explorer/core/observation.hpp"
#include "components/explorer/core/passing_things.hpp"
#include "components/explorer/core/stability_test.hpp"
#include "components/explorer/core/sweeper.hpp"
#include "components/explorer/core/view_planner.hpp"
#include "components/explorer/core/view_targets.hpp"

namespace enfilade::explorer {

struct ExplorationConfig {
  double coarse_step_deg = 1.0;  ///< between the lines of a sweep
  double fine_step_deg = 0.5;    ///< of the sweep that must change nothing
  int max_sweeps_per_zone = 12;  ///< then the room is fixed with what is known
  double widest_door_m =
      1.75;  ///< a wider gap, or one that takes most of its wall, is looked into before the room is fixed
  double whole_wall_share = 0.7;  ///< of the wall, for "most"
  int looks_without_room = 5;     ///< sweeps in a zone where no rectangle fits before it is given up
  double estimate_wait_s = 2.0;   ///< for the estimate of a sweep; then the one at hand is used
  double answer_wait_s = 10.0;    ///< for what follows an accepted request; then it goes on
  double retry_s = 20.0;          ///< stuck, it tries again after this long
  double staging_m = 0.70;        ///< where it looks at a door from
  double staging_search_m = 1.2;  ///< the reachable place nearest to that, at most so far away
  int door_attempts = 2;          ///< failed approaches before a door is put off
  int door_rounds = 2;            ///< so often doors put off are come back to, then they are called blocked
  double give_way_m = 0.6;        ///< it steps so far back from what bars its way
  double watch_s = 10.0;          ///< so long it watches what bars a door, for people who pass
  double outside_m =
      0.30;  ///< so far outside its room a restarted explorer takes it that it has crossed a door
};

struct MachineConfig {
  ExplorationConfig exploration;
  SweeperConfig sweeper;
  StabilityTestConfig stability;
  ViewTargetsConfig targets;
  ViewPlannerConfig views;
  DriveConfig drive;
  DoorGeometryConfig geometry;
  DoorJudgeConfig judge;
  DoorCrossingConfig crossing;
};

/// Section IV as a state machine: look at what is unexplored until nothing changes, fix the room, choose a
/// door, go through it, until no door is left. One step function per state; every wait ends. It keeps nothing
/// that cannot be rebuilt from the current zone, the graph and a new sweep: a new zone, grid epoch or boot of
/// the odometry starts it again.
class ExplorationMachine {
 public:
  explicit ExplorationMachine(const MachineConfig& config);

  /// Call it at the rate of the velocity commands.
  Decision update(const Observation& seen);
  /// As of the last update(); tag and stamp are left to the caller.
  const ExplorationState& state() const { return state_; }

 private:
  enum class Step {
    kWait,
    kSweep,
    kAwaitEstimate,
    kAssess,
    kLook,
    kFix,
    kAwaitRoom,
    kChooseDoor,
    kApproach,
    kJudge,
    kWatch,
    kAlign,
    kCross,
    kBackOff,
    kMark,
    kEnter,
    kAwaitZone,
    kFinished,
    kStuck
  };
  /// Why a sweep is made, which decides what comes after it.
  enum class Purpose { kModel, kVerify, kLocalise, kDoor };

  // exploration_machine.cpp
  bool world_is_ready(const Observation& seen) const;
  bool world_has_changed(const Observation& seen) const;
  void step(const Observation& seen, Decision& decision);
  void start_zone(const Observation& seen, Decision& decision);
  void go_to(Step step, ExplorationPhase phase, std::string activity, const Observation& seen);
  bool waited_s(double s, const Observation& seen) const { return seconds(seen.now_ns - step_since_ns_) > s; }
  void tread(const Observation& seen);
  FloorHints floor_inside(const Observation& seen) const;
  void get_stuck(const std::string& why, const Observation& seen, Decision& decision);
  const Room* current_room(const Observation& seen) const;

  // modelling_steps.cpp: looking until nothing changes
  void begin_sweep(Purpose purpose, const Observation& seen);
  void sweep(const Observation& seen, Decision& decision);
  void await_estimate(const Observation& seen, Decision& decision);
  void after_sweep(const Observation& seen, Decision& decision);
  bool tell_of_new_door(const Observation& seen, Decision& decision);
  void note_what_was_seen(const Observation& seen);
  void note_thresholds(const RoomEstimate& estimate);
  void assess(const Observation& seen, Decision& decision);
  void assess_without_room(const Observation& seen, Decision& decision);
  std::optional<View> next_view(const Observation& seen) const;
  std::optional<View> view_into_gap(const Observation& seen,
                                    const std::function<bool(const DoorEstimate&)>& is_wanted) const;
  const Reach& reach_to_look(Ways& ways) const;
  bool has_looked_from(const Pose2& pose) const;
  void begin_look(const View& view, Purpose purpose, const Observation& seen, Decision& decision);
  void begin_fix(const Observation& seen, Decision& decision);
  void look(const Observation& seen, Decision& decision);
  void fix(const Observation& seen, Decision& decision);
  void await_room(const Observation& seen);

  // door_steps.cpp: leaving the room
  void choose_door(const Observation& seen, Decision& decision);
  bool come_back_to_doors(const Observation& seen, Decision& decision);
  bool is_beyond_a_door(const Observation& seen, Decision& decision);
  std::optional<PlacedDoor> locate_door(const Observation& seen) const;
  void begin_approach(const Observation& seen, Decision& decision);
  void look_for_a_way(const Observation& seen, Decision& decision);
  void approach(const Observation& seen, Decision& decision);
  void judge(const Observation& seen, Decision& decision);
  void begin_watch(Step then, const Observation& seen);
  void watch(const Observation& seen, Decision& decision);
  void give_up_door(const std::string& why, const Observation& seen, Decision& decision);
  void look_behind(const Observation& seen, Decision& decision);
  std::optional<Point2> place_to_give_way(const Observation& seen, const FloorHints& known) const;

  // crossing_steps.cpp: the change of room
  void begin_crossing(const Observation& seen, Decision& decision);
  void align(const Observation& seen, Decision& decision);
  void cross(const Observation& seen, Decision& decision);
  void back_off(const Observation& seen, Decision& decision);
  void begin_mark(DoorKind kind, const Observation& seen, Decision& decision);
  void mark(const Observation& seen, Decision& decision);
  void enter(const Observation& seen, Decision& decision);
  void await_zone(const Observation& seen, Decision& decision);

  ExplorationConfig config_;
  DoorGeometryConfig geometry_;
  DoorJudgeConfig judge_config_;
  Sweeper sweeper_;
  StabilityTest stability_;
  ViewTargets targets_;
  ViewPlanner views_;
  Drive drive_;
  DoorCrossing crossing_;

  ExplorationState state_;
  Step step_ = Step::kWait;
  StampNs step_since_ns_ = 0;
  std::optional<ZoneTag> tag_;  ///< of the grid being worked on

  // Since this zone's grid began.
  Purpose purpose_ = Purpose::kModel;
  bool verified_ = false;
  std::vector<Pose2> swept_from_;
  std::vector<Point2> barred_;  ///< places to look from that could not be got to
  std::vector<Point2> trodden_;
  PassingThings passing_;
  std::vector<Point2> thresholds_;  ///< points in the doorways seen

  // Of the door being dealt with.
  DoorId door_ = 0;
  bool request_sent_ = false;
  bool has_watched_ = false;  ///< in this attempt
  Step after_watch_ = Step::kJudge;
  DoorKind verdict_ = DoorKind::kUnresolved;
  DoorCorridor corridor_;
  std::map<DoorId, int> attempts_;
  std::set<DoorId> avoid_;    ///< put off, or answered where the map may come later than the answer
  std::set<DoorId> put_off_;  ///< could not be reached or crossed in this round
  int door_round_ = 1;
};

}  // namespace enfilade::explorer
