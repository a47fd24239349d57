// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/node/grid_builder_node.hpp"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "components/gridBuilder/core/known_walls.hpp"
#include "interfaces/model/counted.hpp"

namespace enfilade::grid_builder {
namespace {

constexpr const char* kBaseFrame = "base_link";
constexpr const char* kLaserFrame = "laser";
constexpr const char* kZoneFrame = "zone";
constexpr int kFusedPerLine = 3;  // of the lines that have waited, with each that comes
constexpr int kFusedPerPeriod = 12;
constexpr int kPeriodsForDrift = 10;

/// Seconds at the start of the component, so that a restarted one never repeats an epoch. Simulated time does
/// not do for a process, which may start before the first rt/clock; a composed run, which must repeat itself
/// byte for byte, has no other.
std::uint32_t first_epoch(const Clock& clock) {
  if (process_run_id().empty()) return static_cast<std::uint32_t>(1 + clock.now_ns() / from_seconds(1.0));
  const auto since_1970 = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint32_t>(std::chrono::duration_cast<std::chrono::seconds>(since_1970).count());
}

std::vector<CellHit> means_of(const std::vector<HitCell>& cells) {
  std::vector<CellHit> hits;
  hits.reserve(cells.size());
  for (const HitCell& cell : cells) hits.push_back(cell.hit);
  return hits;
}

}  // namespace

GridBuilderNode::GridBuilderNode(const NodeContext& context, const GridBuilderConfig& config)
    : context_(context),
      config_(config),
      gate_(config.gate, first_epoch(context.clock)),
      grid_(config.grid),
      odometry_(config.odometry),
      lines_(config.max_waiting_lines),
      registrar_(config.registration),
      pictures_(context, config.pictures, grid_, config.gate.stationary ? kBaseFrame : kZoneFrame) {}

void GridBuilderNode::initialize() {
  Bus& bus = context_.bus;
  changes_ = bus.advertise(topics::kGridChange);
  hits_ = bus.advertise(topics::kScanHits);
  tf_ = bus.advertise(topics::kTf);
  pictures_.open();
  serve<GridSnapshotRequest, GridSnapshotReply>(bus, topics::kGridSnapshot,
                                                [this](const GridSnapshotRequest&) { return snapshot(); });
  bus.subscribe<TransformList>(topics::kTf, [this](const TransformList& t) { take_tf(t); });
  bus.subscribe<TransformList>(topics::kTfStatic, [this](const TransformList& t) { take_tf_static(t); });
  bus.subscribe<CurrentZone>(topics::kCurrentZone, [this](const CurrentZone& z) { take_zone(z); });
  bus.subscribe<RoomEstimate>(topics::kRoomEstimate, [this](const RoomEstimate& r) { room_ = r; });
  bus.subscribe<MotorState>(topics::kMotorState, [this](const MotorState& s) { take_motor_state(s); });
  bus.subscribe<Odometry>(topics::kOdom, [this](const Odometry& o) { take_odometry(o); });
  bus.subscribe<PointCloud>(topics::kPoints, [this](const PointCloud& p) {
    lines_.add_hits(p);
    work_off_lines();
  });
  bus.subscribe<PointCloud>(topics::kPointsFree, [this](const PointCloud& p) {
    lines_.add_free_ends(p);
    work_off_lines();
  });
  drift_known_ = config_.gate.stationary || !config_.registration.register_scans;
  if (gate_.open()) start_grid();
}

void GridBuilderNode::compute() {
  // The sweep is over and has not told all of where the robot stands.
  if (!std::exchange(line_came_, false) && registrar_.waits()) queue(registrar_.finish());
  fuse(kFusedPerPeriod);
  if (!drift_known_ && T_map_zone_ && ++waited_for_drift_ >= kPeriodsForDrift) start_from({});
  publish_zone_frame();
  if (lines_.overflowed() == overflow_told_) return;
  context_.log.warn(
      counted(lines_.overflowed() - overflow_told_, "scan line") + " dropped: " +
      (origin_base_ ? "no odometry covers them" : "no transform base_link -> laser on rt/tf_static"));
  overflow_told_ = lines_.overflowed();
}

/// Who was started in the middle of a zone learns from the map how far odometry had drifted in it.
void GridBuilderNode::take_tf(const TransformList& transforms) {
  if (drift_known_ || !T_map_zone_) return;
  const auto T_map_odom = find_transform(transforms, "map", "odom");
  if (T_map_odom) start_from(T_map_zone_->inverse() * *T_map_odom);
}

void GridBuilderNode::start_from(const Pose2& T_zone_odom) {
  registrar_.start_from(T_zone_odom);
  drift_known_ = true;
  work_off_lines();
}

void GridBuilderNode::take_tf_static(const TransformList& transforms) {
  for (const StampedTransform& t : transforms.transforms) {
    if (t.frame_id != kBaseFrame || t.child_frame_id != kLaserFrame) continue;
    const Transform3& T = t.transform;
    origin_base_ = Point3f{static_cast<float>(T.x_m), static_cast<float>(T.y_m), static_cast<float>(T.z_m)};
  }
  work_off_lines();
}

void GridBuilderNode::take_zone(const CurrentZone& zone) {
  T_map_zone_ = zone.T_map_zone;
  if (gate_.take(zone)) start_grid();
}

/// After a silence or a jump odometry may count from another origin: only the motors tell.
void GridBuilderNode::take_odometry(const Odometry& odometry) {
  if (odometry_.is_break(odometry)) unsure_since_ns_ = odometry.stamp_ns;
  odometry_.add(odometry);
  if (unsure_since_ns_) return;
  registrar_.move(to_pose2(odometry.T_odom_base));
  work_off_lines();
}

void GridBuilderNode::take_motor_state(const MotorState& state) {
  if (unsure_since_ns_ && state.stamp_ns >= *unsure_since_ns_) unsure_since_ns_.reset();
  if (odom_boot_ && *odom_boot_ != state.odom_boot) {
    // Poses of another boot count from where the robot stood when the one before ended.
    unsure_since_ns_.reset();
    odometry_.clear();
    lines_.clear();
    registrar_.forget_odometry();
    drift_known_ = true;
    settled_.clear();
    publish_zone_frame();
  }
  odom_boot_ = state.odom_boot;
  if (gate_.take(state)) start_grid();
}

void GridBuilderNode::start_grid() {
  grid_.clear();
  pictures_.grid_cleared();
  registrar_.forget_lines();
  settled_.clear();
  memory_told_ = false;
  newest_line_ns_ = 0;
  const ZoneTag tag = gate_.tag();
  context_.log.info("zone " + std::to_string(tag.zone_id) + ": empty grid, epoch " +
                    std::to_string(tag.grid_epoch));
  changes_.publish(change(context_.clock.now_ns(), {}));
}

void GridBuilderNode::work_off_lines() {
  if (!origin_base_ || !drift_known_ || unsure_since_ns_) return;
  while (const BaseLine* next = lines_.front()) {
    if (!config_.gate.stationary && !odometry_.reaches(next->stamp_ns)) return;
    const BaseLine line = lines_.pop();
    if (!gate_.accepts(line.stamp_ns)) continue;
    const auto moment = find_moment(line.stamp_ns);
    if (!moment || moment->moving) continue;
    line_came_ = true;
    queue(registrar_.take({line, moment->T_odom_base}, walls()));
    fuse(kFusedPerLine);
  }
}

std::optional<BaseMoment> GridBuilderNode::find_moment(StampNs stamp_ns) const {
  if (config_.gate.stationary) return BaseMoment{};
  return odometry_.find_moment(stamp_ns);
}

/// The room as this grid shows it, if one was found.
std::optional<KnownWalls> GridBuilderNode::walls() const {
  const bool is_ours = room_.found && room_.tag == gate_.tag();
  return is_ours ? std::optional(known_walls(room_, config_.registration.max_wall_sigma_m)) : std::nullopt;
}

void GridBuilderNode::queue(const std::vector<PlacedLine>& lines) {
  for (const PlacedLine& placed : lines)
    settled_.push_back({placed.line, registrar_.T_zone_odom() * placed.T_odom_base});
}

/// Lines that have waited for their pose come all at once. They are fused a few at a time, since each is a
/// message that readers must have worked off before their queues are full.
void GridBuilderNode::fuse(int most) {
  for (; most > 0 && !settled_.empty(); --most) {
    const SettledLine settled = std::move(settled_.front());
    settled_.pop_front();
    insert(settled.line, settled.T_zone_base);
  }
}

/// Odometry never jumps, and the zone's frame stands still: what drifts between them hangs below odom.
void GridBuilderNode::publish_zone_frame() {
  if (!drift_known_ || config_.gate.stationary) return;
  tf_.publish(
      {{{context_.clock.now_ns(), "odom", kZoneFrame, to_transform3(registrar_.T_zone_odom().inverse())}}});
}

/// Returns go out before the cells they change are known: readers work on them meanwhile.
void GridBuilderNode::insert(const BaseLine& line, const Pose2& T_zone_base) {
  const ScanLine placed = place(line, *origin_base_, T_zone_base);
  const std::vector<HitCell> hits = grid_.hit_cells(placed);
  if (line.has_hits) hits_.publish({gate_.tag(), line.stamp_ns, T_zone_base, means_of(hits)});
  LineUpdate update = grid_.insert(placed, hits);
  if (update.cells_without_memory > 0 && !std::exchange(memory_told_, true)) {
    context_.log.warn("the grid is full: raise grid.max_memory_mb or lower grid.max_range_m");
  }
  newest_line_ns_ = std::max(newest_line_ns_, line.stamp_ns);
  pictures_.line_fused(update, line.stamp_ns, T_zone_base);
  if (!line.has_hits && update.changes.empty()) return;
  gate_.next_sequence();
  changes_.publish(change(newest_line_ns_, std::move(update.changes)));
}

GridChange GridBuilderNode::change(StampNs stamp_ns, std::vector<GridCell> cells) const {
  return {gate_.tag(), gate_.sequence(), stamp_ns, config_.grid.resolution_m, std::move(cells)};
}

/// A repeated request gets what is known now: a newer answer to the same question.
GridSnapshotReply GridBuilderNode::snapshot() const {
  return {{}, change(newest_line_ns_, grid_.known_cells())};
}

}  // namespace enfilade::grid_builder
