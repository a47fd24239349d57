// SPDX-License-Identifier: Apache-2.0
#include "interfaces/convert/metric_map.hpp"

#include <cmath>

namespace enfilade::wire {

namespace {

constexpr const char* kOcTree = "OcTree";

void check_resolution(double resolution_m, const char* what) {
  if (std::isfinite(resolution_m) && resolution_m > 0.0) return;
  throw WireError(std::string("the resolution of ") + what + " is " + std::to_string(resolution_m) + " m");
}

}  // namespace

ros_nav::OccupancyGrid_ to_wire(const OccupancyMap& map) {
  ros_nav::OccupancyGrid_ out;
  out.header(header_to_wire(map.stamp_ns, map.frame_id));
  out.info().map_load_time(to_wire(map.stamp_ns));
  out.info().resolution(map.resolution_m);
  out.info().width(map.columns);
  out.info().height(map.rows);
  const Transform3& T = map.T_frame_cells;
  auto& position = out.info().origin().position();
  position.x(T.x_m), position.y(T.y_m), position.z(T.z_m);
  auto& rotation = out.info().origin().orientation();
  rotation.x(T.qx), rotation.y(T.qy), rotation.z(T.qz), rotation.w(T.qw);
  out.data(map.cells);
  return out;
}

OccupancyMap from_wire(const ros_nav::OccupancyGrid_& grid) {
  const auto& info = grid.info();
  check_count(grid.data().size(), kMaxMapCells, "cells of a map");
  check_resolution(static_cast<double>(info.resolution()), "a map");
  if (std::uint64_t{info.width()} * info.height() != grid.data().size()) {
    throw WireError("a map of " + std::to_string(info.width()) + " x " + std::to_string(info.height()) +
                    " cells has " + std::to_string(grid.data().size()));
  }
  const auto& t = info.origin().position();
  const auto& q = info.origin().orientation();
  return {.stamp_ns = from_wire(grid.header().stamp()),
          .frame_id = checked(grid.header().frame_id()),
          .resolution_m = info.resolution(),
          .columns = info.width(),
          .rows = info.height(),
          .T_frame_cells = {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()},
          .cells = grid.data()};
}

ros_octomap::Octomap_ to_wire(const OctreeMap& map) {
  ros_octomap::Octomap_ out;
  out.header(header_to_wire(map.stamp_ns, map.frame_id));
  out.binary(true);
  out.id(kOcTree);
  out.resolution(map.resolution_m);
  out.data(map.data);
  return out;
}

OctreeMap from_wire(const ros_octomap::Octomap_& octomap) {
  check_count(octomap.data().size(), kMaxOctreeBytes, "bytes of an octree");
  check_resolution(octomap.resolution(), "an octree");
  if (!octomap.binary() || octomap.id() != kOcTree)
    throw WireError("an octree is no binary OcTree but " + checked(octomap.id()));
  return {from_wire(octomap.header().stamp()), checked(octomap.header().frame_id()), octomap.resolution(),
          octomap.data()};
}

}  // namespace enfilade::wire
