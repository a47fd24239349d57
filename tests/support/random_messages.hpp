// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "interfaces/topics/topics.hpp"

namespace enfilade::test {

/// Makes messages of every type in which every member, list and option varies, and which are valid on the
/// wire.
class RandomMessages {
 public:
  explicit RandomMessages(std::uint64_t seed) : bits_(seed) {}

  template <class T>
  T make() {
    T value{};
    fill(value);
    return value;
  }

 private:
  std::uint64_t below(std::uint64_t end) { return bits_() % end; }

  template <class... T>
  void all(T&... members) {
    (fill(members), ...);
  }

  template <class E>
  requires std::is_enum_v<E>
  void pick(E& value, E last) { value = static_cast<E>(below(static_cast<std::uint64_t>(last) + 1)); }

  void fill(bool& value) { value = below(2) == 1; }
  template <class I>
  requires std::is_integral_v<I>
  void fill(I& value) { value = static_cast<I>(bits_()); }
  void fill(StampNs& value) {
    value = static_cast<StampNs>(below(4'000'000'000'000'000'000)) - 2'000'000'000'000'000'000;
  }
  /// Any value that equals itself.
  void fill(double& value) {
    do value = std::bit_cast<double>(bits_());
    while (value != value);
  }
  void fill(float& value) {
    do value = std::bit_cast<float>(static_cast<std::uint32_t>(bits_()));
    while (value != value);
  }
  void fill(std::string& value) {
    value.resize(below(20));
    for (char& c : value) c = static_cast<char>('a' + below(26));
  }
  void fill(Point2& value) { all(value.x(), value.y()); }
  template <class T>
  void fill(std::vector<T>& values) {
    values.resize(below(30));
    for (T& value : values) fill(value);
  }
  template <class T>
  void fill(std::optional<T>& value) {
    if (below(2) == 1) fill(value.emplace());
  }
  void fill(RectangleCovariance& values) {
    for (double& value : values) fill(value);
  }

  void fill(Pose2& v) { all(v.x_m, v.y_m, v.yaw_rad); }
  void fill(Rectangle& v) { all(v.yaw_rad, v.x_m, v.y_m, v.width_m, v.height_m); }
  void fill(ZoneTag& v) { all(v.zone_id, v.grid_epoch, v.odom_boot); }
  void fill(CallId& v) { all(v.client, v.number); }
  void fill(Transform3& v) { all(v.x_m, v.y_m, v.z_m, v.qx, v.qy, v.qz, v.qw); }
  void fill(StampedTransform& v) { all(v.stamp_ns, v.frame_id, v.child_frame_id, v.transform); }
  void fill(TransformList& v) { all(v.transforms); }

  /// Ranges of any bit pattern, NaN with payloads included.
  void fill(LaserScan& v) {
    all(v.stamp_ns, v.frame_id, v.angle_min_rad, v.angle_max_rad, v.angle_increment_rad, v.time_increment_s,
        v.scan_time_s, v.range_min_m, v.range_max_m, v.ranges_m, v.intensities);
    for (float& range : v.ranges_m) range = std::bit_cast<float>(static_cast<std::uint32_t>(bits_()));
    v.ranges_m.push_back(std::bit_cast<float>(0x7fc12345U));
    v.ranges_m.push_back(std::numeric_limits<float>::infinity());
  }
  void fill(Point3f& v) { all(v.x_m, v.y_m, v.z_m); }
  void fill(PointCloud& v) { all(v.stamp_ns, v.frame_id, v.points); }
  void fill(JointStates& v) {
    all(v.stamp_ns, v.names, v.positions_rad, v.velocities_rad_s);
    v.positions_rad.resize(v.names.size());
    v.velocities_rad_s.resize(v.names.size());
  }
  void fill(Odometry& v) { all(v.stamp_ns, v.T_odom_base, v.linear_m_s, v.angular_rad_s); }

  void fill(VelocityCommand& v) { all(v.linear_m_s, v.angular_rad_s); }
  void fill(SweepCommand& v) {
    all(v.sweep_id, v.from_rad, v.to_rad, v.speed_rad_s);
    pick(v.action, SweepAction::kPark);
  }
  void fill(MotorState& v) {
    all(v.stamp_ns, v.odom_boot, v.sweep_id, v.sweep_start_ns, v.sweep_end_ns, v.base_moving);
    pick(v.phase, SweepPhase::kDone);
  }
  void fill(Heartbeat& v) {
    all(v.component_name, v.host, v.pid, v.wall_ns, v.cycles, v.detail);
    pick(v.state, LifecycleState::kStopping);
  }
  void fill(LogLine& v) { all(v.stamp_ns, v.level, v.component_name, v.text); }
  void fill(ClockTick& v) { all(v.now_ns); }
  void fill(SimCredit& v) { all(v.component_name, v.done_ns); }
  void fill(SimActuation& v) { all(v.left_wheel_rad_s, v.right_wheel_rad_s, v.roll_rad_s); }
  void fill(SimEncoders& v) {
    all(v.stamp_ns, v.left_wheel_rad, v.right_wheel_rad, v.roll_rad, v.roll_rad_s);
  }
  void fill(GroundTruth& v) { all(v.stamp_ns, v.T_world_base, v.collisions, v.path_length_m); }

  void fill(OccupancyMap& v) {
    all(v.stamp_ns, v.frame_id, v.T_frame_cells);
    v.resolution_m = static_cast<float>(1 + below(1'000'000)) * 1e-4F;
    v.columns = static_cast<std::uint32_t>(below(20));
    v.rows = static_cast<std::uint32_t>(below(20));
    v.cells.resize(v.columns * v.rows);
    for (std::int8_t& cell : v.cells) fill(cell);
  }
  void fill(OctreeMap& v) {
    all(v.stamp_ns, v.frame_id, v.data);
    v.resolution_m = static_cast<double>(1 + below(1'000'000)) * 1e-4;
  }

  void fill(GridCell& v) {
    all(v.x, v.y, v.z);
    pick(v.state, CellState::kOccupied);
  }
  void fill(GridChange& v) {
    all(v.tag, v.sequence, v.stamp_ns, v.cells);
    v.resolution_m = static_cast<double>(1 + below(1'000'000)) * 1e-4;
  }
  void fill(CellHit& v) {
    all(v.x_m, v.y_m, v.z_m);
    v.count = static_cast<std::uint16_t>(1 + below(65'535));
  }
  void fill(ScanHits& v) { all(v.tag, v.stamp_ns, v.T_zone_base, v.hits); }

  void fill(WallInterval& v) {
    all(v.from_m, v.to_m);
    v.wall = static_cast<std::uint8_t>(below(4));
  }
  void fill(DoorEvidence& v) {
    all(v.occupied_share, v.free_share, v.beyond_occupied_cells, v.beyond_free_cells);
  }
  void fill(DoorEstimate& v) {
    all(v.gap, v.height_m, v.evidence, v.position_sigma_m, v.width_sigma_m, v.height_sigma_m);
    pick(v.state, DoorState::kUnexplored);
  }
  void fill(RoomEstimate& v) {
    all(v.tag, v.grid_sequence, v.stamp_ns, v.found, v.rectangle, v.score, v.covariance, v.polygon, v.doors,
        v.unexplored_wall_share, v.recent, v.recent_stamp_ns);
  }
  void fill(WallDiagnostics& v) { all(v.occupied, v.free, v.toll, v.returns, v.moved_m); }
  void fill(RejectedRectangle& v) { all(v.rectangle, v.score, v.reason); }
  void fill(GapDiagnostics& v) {
    all(v.gap, v.reason, v.occupied_share, v.free_share, v.foot_free_share, v.open_nats, v.from_sigma_m,
        v.to_sigma_m);
    pick(v.verdict, GapVerdict::kNoDoor);
  }
  void fill(HoughSlice& v) {
    all(v.yaw_rad, v.origin, v.d_from_m, v.p_from_m, v.cell_m, v.full_scale);
    v.columns = static_cast<std::uint32_t>(below(20));
    v.rows = static_cast<std::uint32_t>(below(20));
    v.levels.resize(v.columns * v.rows);
    for (std::uint8_t& level : v.levels) fill(level);
  }
  void fill(RoomDiagnostics& v) {
    all(v.tag, v.grid_sequence, v.stamp_ns, v.found, v.above_furniture, v.coarse, v.score, v.score_gap,
        v.interior, v.slice, v.rejected, v.gaps);
    for (WallDiagnostics& wall : v.walls) fill(wall);
  }
  void fill(DoorFace& v) { all(v.room, v.gap, v.position_sigma_m, v.measured_offset_m); }
  void fill(Door& v) {
    all(v.id, v.face, v.other_face, v.height_m, v.thickness_m, v.measured_thickness_m, v.driven, v.closed);
    pick(v.kind, DoorKind::kBlocked);
  }
  void fill(Room& v) {
    all(v.id, v.name, v.T_map_room, v.width_m, v.height_m, v.measured_size_m, v.covariance, v.polygon,
        v.zone_id, v.fixed_ns, v.seen_ns, v.T_room_base, v.place);
  }
  void fill(RoomLink& v) { all(v.from, v.to, v.T_from_to, v.sigma_position_m, v.sigma_yaw_rad); }
  void fill(Place& v) {
    all(v.id, v.parent, v.name);
    pick(v.kind, PlaceKind::kFloor);
  }
  void fill(TopologicalMap& v) { all(v.version, v.stamp_ns, v.rooms, v.doors, v.links, v.places); }
  void fill(CurrentZone& v) {
    all(v.zone_id, v.room, v.from_room, v.via_door, v.T_map_zone, v.located, v.valid_from_ns);
  }
  void fill(PoseCorrection& v) {
    all(v.stamp_ns, v.room, v.deviation, v.T_map_odom);
    pick(v.reason, PoseCorrection::Reason::kLocalised);
  }
  void fill(ExplorationState& v) {
    all(v.tag, v.stamp_ns, v.activity, v.sweeps_in_zone, v.sweeps_total, v.unexplored_wall_share, v.room,
        v.target_door, v.goal);
    pick(v.phase, ExplorationPhase::kStuck);
  }

  void fill(FixRoomRequest& v) { all(v.call, v.estimate); }
  void fill(FixRoomReply& v) { all(v.call, v.accepted, v.message, v.room); }
  void fill(EnterZoneRequest& v) { all(v.call, v.from_room, v.via_door, v.T_zone_base, v.stamp_ns); }
  void fill(EnterZoneReply& v) { all(v.call, v.accepted, v.message, v.zone_id); }
  void fill(MarkDoorRequest& v) {
    all(v.call, v.door, v.closed);
    pick(v.kind, DoorKind::kBlocked);
  }
  void fill(MarkDoorReply& v) { all(v.call, v.accepted, v.message); }
  void fill(RoutePlace& v) { all(v.room, v.point); }
  void fill(RouteRequest& v) { all(v.call, v.start, v.goal, v.closed_doors); }
  void fill(RouteLeg& v) {
    all(v.room, v.enter, v.leave, v.door);
    if (v.door == DoorId{0}) v.door.reset();  // ids are from 1
  }
  void fill(Route& v) { all(v.legs, v.length_m); }
  void fill(RouteReply& v) { all(v.call, v.found, v.message, v.route); }
  void fill(GridSnapshotRequest& v) { all(v.call); }
  void fill(GridSnapshotReply& v) { all(v.call, v.snapshot); }

  std::mt19937_64 bits_;
};

inline bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](float x, float y) {
    return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
  });
}

/// Equality that holds for NaN too.
template <class T>
bool same(const T& a, const T& b) {
  if constexpr (std::is_same_v<T, LaserScan>) {
    return a.stamp_ns == b.stamp_ns && a.frame_id == b.frame_id && same_bits(a.ranges_m, b.ranges_m) &&
           same_bits(a.intensities, b.intensities) &&
           same_bits({a.angle_min_rad, a.angle_max_rad, a.angle_increment_rad, a.time_increment_s,
                      a.scan_time_s, a.range_min_m, a.range_max_m},
                     {b.angle_min_rad, b.angle_max_rad, b.angle_increment_rad, b.time_increment_s,
                      b.scan_time_s, b.range_min_m, b.range_max_m});
  } else {
    return a == b;
  }
}

}  // namespace enfilade::test
