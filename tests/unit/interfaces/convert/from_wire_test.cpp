// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "interfaces/convert/grid.hpp"
#include "interfaces/convert/metric_map.hpp"
#include "interfaces/convert/motion.hpp"
#include "interfaces/convert/requests.hpp"
#include "interfaces/convert/sensing.hpp"

namespace enfilade {
namespace {

using wire::WireError;

const PointCloud kCloud{7, "base_link", {{1, 2, 3}, {4, 5, 6}}};

TEST(PointCloudFromWire, RefusesSizesThatContradictEachOther) {
  auto cloud = wire::to_wire(kCloud);
  cloud.width(3);
  EXPECT_THROW(wire::from_wire(cloud), WireError);
  cloud = wire::to_wire(kCloud);
  cloud.data().pop_back();
  EXPECT_THROW(wire::from_wire(cloud), WireError);
  cloud = wire::to_wire(kCloud);
  cloud.point_step(0x80000000U);
  EXPECT_THROW(wire::from_wire(cloud), WireError);
  cloud = wire::to_wire(kCloud);
  cloud.width(0xffffffffU), cloud.height(0xffffffffU), cloud.row_step(0);
  EXPECT_THROW(wire::from_wire(cloud), WireError);
  cloud = wire::to_wire(kCloud);
  cloud.width(0xffffffffU), cloud.height(1), cloud.point_step(0), cloud.row_step(0), cloud.data().clear();
  EXPECT_THROW(wire::from_wire(cloud), WireError);
}

TEST(PointCloudFromWire, RefusesFieldsThatAreMissingOrOutsideTheirPointOrNoFloat32) {
  auto cloud = wire::to_wire(kCloud);
  cloud.fields().pop_back();
  EXPECT_THROW(wire::from_wire(cloud), WireError);
  cloud = wire::to_wire(kCloud);
  cloud.fields()[2].offset(9);
  EXPECT_THROW(wire::from_wire(cloud), WireError);
  cloud.fields()[2].offset(0xfffffffeU);
  EXPECT_THROW(wire::from_wire(cloud), WireError);
  cloud = wire::to_wire(kCloud);
  cloud.fields()[0].datatype(8);
  EXPECT_THROW(wire::from_wire(cloud), WireError);
}

/// Two rows of one point each; a point is {intensity, z, y, x}, and each row ends with four bytes of padding.
TEST(PointCloudFromWire, ReadsFieldsAtAnyOffsetRowByRow) {
  auto cloud = wire::to_wire(kCloud);
  const float data[] = {9, 3, 2, 1, -1, 9, 6, 5, 4, -1};
  cloud.height(2), cloud.width(1), cloud.point_step(16), cloud.row_step(20);
  cloud.fields()[0].offset(12), cloud.fields()[1].offset(8), cloud.fields()[2].offset(4);
  cloud.data().resize(sizeof data);
  std::memcpy(cloud.data().data(), data, sizeof data);
  EXPECT_EQ(wire::from_wire(cloud), kCloud);
}

TEST(PointCloudFromWire, ReadsBigEndianPoints) {
  auto cloud = wire::to_wire(kCloud);
  cloud.is_bigendian(true);
  auto& data = cloud.data();
  for (std::size_t i = 0; i < data.size(); i += 4)
    std::swap(data[i], data[i + 3]), std::swap(data[i + 1], data[i + 2]);
  EXPECT_EQ(wire::from_wire(cloud), kCloud);
}

TEST(JointStatesFromWire, FillsVelocitiesThatAreAbsentAndRefusesOtherLengths) {
  auto joints = wire::to_wire(JointStates{1, {"a", "b"}, {1, 2}, {3, 4}});
  joints.velocity().clear();
  EXPECT_EQ(wire::from_wire(joints).velocities_rad_s, (std::vector<double>{0, 0}));
  joints.position().pop_back();
  EXPECT_THROW(wire::from_wire(joints), WireError);
}

TEST(StampFromWire, CountsNanosecondsUpwardsBeforeTheEpochToo) {
  const auto time = wire::to_wire(StampNs{-1});
  EXPECT_EQ(time.sec(), -1);
  EXPECT_EQ(time.nanosec(), 999'999'999U);
  EXPECT_EQ(wire::from_wire(time), -1);
}

TEST(StampFromWire, RefusesWhatIsNoTime) {
  auto time = wire::to_wire(StampNs{0});
  time.nanosec(1'000'000'000);
  EXPECT_THROW(wire::from_wire(time), WireError);
  EXPECT_THROW(wire::to_wire(StampNs{3'000'000'000'000'000'000}), WireError);
}

TEST(EnumFromWire, RefusesValuesThatMeanNothing) {
  auto state = wire::to_wire(MotorState{});
  state.phase(4);
  EXPECT_THROW(wire::from_wire(state), WireError);
  auto request = wire::to_wire(MarkDoorRequest{});
  request.kind(200);
  EXPECT_THROW(wire::from_wire(request), WireError);
}

TEST(GridFromWire, RefusesAGridWithoutAResolution) {
  EXPECT_NO_THROW(wire::from_wire(wire::to_wire(GridChange{.resolution_m = 0.05})));
  for (const double bad :
       {0.0, -0.05, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const auto change = wire::to_wire(GridChange{.resolution_m = bad});
    EXPECT_THROW(wire::from_wire(change), WireError) << bad;
    EXPECT_THROW(wire::from_wire(wire::to_wire(GridSnapshotReply{.snapshot = {.resolution_m = bad}})),
                 WireError);
  }
}

TEST(GridFromWire, RefusesACellHitByNothing) {
  EXPECT_NO_THROW(wire::from_wire(wire::to_wire(ScanHits{.hits = {{1, 2, 3, 1}}})));
  EXPECT_THROW(wire::from_wire(wire::to_wire(ScanHits{.hits = {{1, 2, 3, 0}}})), WireError);
}

TEST(MapFromWire, RefusesCellsThatContradictItsSizes) {
  const OccupancyMap map{.resolution_m = 0.05F, .columns = 3, .rows = 2, .cells = {0, 100, -1, 0, 0, 0}};
  EXPECT_EQ(wire::from_wire(wire::to_wire(map)), map);
  auto grid = wire::to_wire(map);
  grid.info().width(4);
  EXPECT_THROW(wire::from_wire(grid), WireError);
  grid.info().width(0xffffffffU), grid.info().height(0xffffffffU);
  EXPECT_THROW(wire::from_wire(grid), WireError);
  grid = wire::to_wire(map);
  grid.info().resolution(0.0F);
  EXPECT_THROW(wire::from_wire(grid), WireError);
}

TEST(OctreeFromWire, RefusesTreesOfOtherKinds) {
  const OctreeMap map{.resolution_m = 0.05, .data = {1, 2}};
  EXPECT_EQ(wire::from_wire(wire::to_wire(map)), map);
  auto octomap = wire::to_wire(map);
  octomap.binary(false);
  EXPECT_THROW(wire::from_wire(octomap), WireError);
  octomap = wire::to_wire(map);
  octomap.id("ColorOcTree");
  EXPECT_THROW(wire::from_wire(octomap), WireError);
  octomap = wire::to_wire(map);
  octomap.resolution(-1.0);
  EXPECT_THROW(wire::from_wire(octomap), WireError);
}

TEST(RoomFromWire, RefusesAGapInAFifthWall) {
  auto gap = wire::to_wire(WallInterval{.wall = 3});
  gap.wall(4);
  EXPECT_THROW(wire::from_wire(gap), WireError);
}

TEST(CountsFromWire, AreBelievedUpToTheirBound) {
  EXPECT_NO_THROW(wire::check_count(wire::kMaxBeams, wire::kMaxBeams, "ranges"));
  EXPECT_THROW(wire::check_count(wire::kMaxBeams + 1, wire::kMaxBeams, "ranges"), WireError);
}

}  // namespace
}  // namespace enfilade
