// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "interfaces/model/exploration.hpp"
#include "interfaces/model/grid.hpp"
#include "interfaces/model/health.hpp"
#include "interfaces/model/metric_map.hpp"
#include "interfaces/model/motion.hpp"
#include "interfaces/model/requests.hpp"
#include "interfaces/model/room.hpp"
#include "interfaces/model/room_diagnostics.hpp"
#include "interfaces/model/sensing.hpp"
#include "interfaces/model/simulation.hpp"
#include "interfaces/model/topological_map.hpp"
#include "interfaces/model/transform.hpp"
#include "interfaces/topics/topic.hpp"

/// The one table of what travels: topic, type, QoS, nominal rate, writers, readers.
namespace enfilade::topics {

inline constexpr Qos kStream{.reliable = true, .latched = false, .depth = 100};
inline constexpr Qos kBulk{.reliable = true, .latched = false, .depth = 100};
inline constexpr Qos kState{.reliable = true, .latched = true, .depth = 1};
inline constexpr Qos kCall{.reliable = true, .latched = false, .depth = 16};

// clang-format off

// Standard ROS 2 topics.
inline constexpr Topic<ClockTick>     kClock      {{"rt/clock",        "rosgraph_msgs::msg::dds_::Clock_",       kStream, 200, "simulator", "*"}};
inline constexpr Topic<LaserScan>     kScan       {{"rt/scan",         "sensor_msgs::msg::dds_::LaserScan_",     kBulk,    40, "laser3D", ""}};
inline constexpr Topic<PointCloud>    kPoints     {{"rt/points",       "sensor_msgs::msg::dds_::PointCloud2_",   kBulk,    40, "laser3D", "gridBuilder explorer"}};
inline constexpr Topic<PointCloud>    kPointsFree {{"rt/points_free",  "sensor_msgs::msg::dds_::PointCloud2_",   kBulk,    40, "laser3D", "gridBuilder"}};
inline constexpr Topic<JointStates>   kJointStates{{"rt/joint_states", "sensor_msgs::msg::dds_::JointState_",    kStream, 200, "motorControl", "laser3D"}};
inline constexpr Topic<Odometry>      kOdom       {{"rt/odom",         "nav_msgs::msg::dds_::Odometry_",         kStream,  50, "motorControl", "gridBuilder explorer"}};
inline constexpr Topic<TransformList> kTf         {{"rt/tf",           "tf2_msgs::msg::dds_::TFMessage_",        kStream,  50, "motorControl topoGraph laser3D gridBuilder", "explorer topoGraph gridBuilder"}};
inline constexpr Topic<TransformList> kTfStatic   {{"rt/tf_static",    "tf2_msgs::msg::dds_::TFMessage_",        kState,    0, "laser3D", "gridBuilder"}};
inline constexpr Topic<VelocityCommand> kCmdVel   {{"rt/cmd_vel",      "geometry_msgs::msg::dds_::Twist_",       kCall,    20, "explorer", "motorControl"}};
inline constexpr Topic<OccupancyMap>  kMap        {{"rt/map",          "nav_msgs::msg::dds_::OccupancyGrid_",    kState,    0, "topoGraph", ""}};
inline constexpr Topic<OccupancyMap>  kLocalMap   {{"rt/local_map",    "nav_msgs::msg::dds_::OccupancyGrid_",    kState,    1, "gridBuilder", ""}};
inline constexpr Topic<OctreeMap>     kOctomap    {{"rt/octomap",      "octomap_msgs::msg::dds_::Octomap_",      kState,    1, "gridBuilder", ""}};
inline constexpr Topic<LogLine>       kRosout     {{"rt/rosout",       "rcl_interfaces::msg::dds_::Log_",        {true, true, 200}, 0, "* simulator", ""}};

// Our own.
inline constexpr Topic<SweepCommand>     kSweepCommand    {{"rt/enfilade/sweep_command",     "enfilade_msgs::msg::dds_::SweepCommand_",     kState,  0, "explorer", "motorControl"}};
inline constexpr Topic<MotorState>       kMotorState      {{"rt/enfilade/motor_state",       "enfilade_msgs::msg::dds_::MotorState_",       kState,  2, "motorControl", "gridBuilder explorer"}};
inline constexpr Topic<GridChange>       kGridChange      {{"rt/enfilade/grid_change",       "enfilade_msgs::msg::dds_::GridChange_",       kBulk,  40, "gridBuilder", "roomDetector explorer"}};
inline constexpr Topic<ScanHits>         kScanHits        {{"rt/enfilade/scan_hits",         "enfilade_msgs::msg::dds_::ScanHits_",         kBulk,  40, "gridBuilder", "roomDetector"}};
inline constexpr Topic<RoomEstimate>     kRoomEstimate    {{"rt/enfilade/room_estimate",     "enfilade_msgs::msg::dds_::RoomEstimate_",     kState, 40, "roomDetector", "explorer topoGraph gridBuilder"}};
inline constexpr Topic<RoomDiagnostics>  kRoomDiagnostics {{"rt/enfilade/room_diagnostics",  "enfilade_msgs::msg::dds_::RoomDiagnostics_",  kState,  1, "roomDetector", ""}};
inline constexpr Topic<ExplorationState> kExplorationState{{"rt/enfilade/exploration_state", "enfilade_msgs::msg::dds_::ExplorationState_", kState,  2, "explorer", ""}};
inline constexpr Topic<TopologicalMap>   kTopologicalMap  {{"rt/enfilade/topological_map",   "enfilade_msgs::msg::dds_::TopologicalMap_",   kState,  0, "topoGraph", "explorer"}};
inline constexpr Topic<CurrentZone>      kCurrentZone     {{"rt/enfilade/current_zone",      "enfilade_msgs::msg::dds_::CurrentZone_",      kState,  0, "topoGraph", "gridBuilder explorer"}};
inline constexpr Topic<PoseCorrection>   kPoseCorrection  {{"rt/enfilade/pose_correction",   "enfilade_msgs::msg::dds_::PoseCorrection_",   kState,  0, "topoGraph", ""}};
inline constexpr Topic<Heartbeat>        kHeartbeat       {{"rt/enfilade/heartbeat",         "enfilade_msgs::msg::dds_::Heartbeat_",        kCall,   2, "* simulator", ""}};

// Between the simulator and the drivers that stand before it.
inline constexpr Topic<SimCredit>    kSimCredit   {{"rt/sim/credit",       "enfilade_msgs::msg::dds_::SimCredit_",    kStream, 40, "*", "simulator"}};
inline constexpr Topic<SimActuation> kSimActuation{{"rt/sim/actuation",    "enfilade_msgs::msg::dds_::SimActuation_", kStream, 50, "motorControl", "simulator"}};
inline constexpr Topic<SimEncoders>  kSimEncoders {{"rt/sim/encoders",     "enfilade_msgs::msg::dds_::SimEncoders_",  kStream, 200, "simulator", "motorControl"}};
inline constexpr Topic<LaserScan>    kSimScan     {{"rt/sim/scan",         "sensor_msgs::msg::dds_::LaserScan_",      kBulk,  40, "simulator", "laser3D"}};
inline constexpr Topic<GroundTruth>  kGroundTruth {{"rt/sim/ground_truth", "enfilade_msgs::msg::dds_::GroundTruth_",  kStream, 20, "simulator", ""}};

// Requests.
inline constexpr Service<FixRoomRequest, FixRoomReply> kFixRoom{
    {{"rq/enfilade/fix_roomRequest", "enfilade_msgs::srv::dds_::FixRoom_Request_", kCall, 0, "explorer", "topoGraph"}},
    {{"rr/enfilade/fix_roomReply",   "enfilade_msgs::srv::dds_::FixRoom_Response_", kCall, 0, "topoGraph", "explorer"}}};
inline constexpr Service<EnterZoneRequest, EnterZoneReply> kEnterZone{
    {{"rq/enfilade/enter_zoneRequest", "enfilade_msgs::srv::dds_::EnterZone_Request_", kCall, 0, "explorer", "topoGraph"}},
    {{"rr/enfilade/enter_zoneReply",   "enfilade_msgs::srv::dds_::EnterZone_Response_", kCall, 0, "topoGraph", "explorer"}}};
inline constexpr Service<MarkDoorRequest, MarkDoorReply> kMarkDoor{
    {{"rq/enfilade/mark_doorRequest", "enfilade_msgs::srv::dds_::MarkDoor_Request_", kCall, 0, "explorer enfilade", "topoGraph"}},
    {{"rr/enfilade/mark_doorReply",   "enfilade_msgs::srv::dds_::MarkDoor_Response_", kCall, 0, "topoGraph", "explorer"}}};
inline constexpr Service<RouteRequest, RouteReply> kRoute{
    {{"rq/enfilade/routeRequest", "enfilade_msgs::srv::dds_::Route_Request_", kCall, 0, "enfilade", "topoGraph"}},
    {{"rr/enfilade/routeReply",   "enfilade_msgs::srv::dds_::Route_Response_", kCall, 0, "topoGraph", ""}}};
inline constexpr Service<GridSnapshotRequest, GridSnapshotReply> kGridSnapshot{
    {{"rq/enfilade/grid_snapshotRequest", "enfilade_msgs::srv::dds_::GridSnapshot_Request_", kCall, 0, "roomDetector explorer", "gridBuilder"}},
    {{"rr/enfilade/grid_snapshotReply",   "enfilade_msgs::srv::dds_::GridSnapshot_Response_", kCall, 0, "gridBuilder", "roomDetector explorer"}}};

// clang-format on

/// Calls `visit(topic)` with every topic of the table, requests and replies included.
template <class Visitor>
void for_each_topic(Visitor&& visit) {
  const auto all = [&visit](const auto&... topic) { (visit(topic), ...); };
  all(kClock, kScan, kPoints, kPointsFree, kJointStates, kOdom, kTf, kTfStatic, kCmdVel, kMap, kLocalMap,
      kOctomap, kRosout);
  all(kSweepCommand, kMotorState, kGridChange, kScanHits, kRoomEstimate, kRoomDiagnostics, kExplorationState,
      kTopologicalMap, kCurrentZone, kPoseCorrection, kHeartbeat);
  all(kSimCredit, kSimActuation, kSimEncoders, kSimScan, kGroundTruth);
  const auto services = [&all](const auto&... service) { (all(service.request, service.reply), ...); };
  services(kFixRoom, kEnterZone, kMarkDoor, kRoute, kGridSnapshot);
}

/// The table's rows.
std::vector<TopicInfo> table();

}  // namespace enfilade::topics
