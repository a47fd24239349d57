// SPDX-License-Identifier: Apache-2.0
#include "interfaces/convert/room.hpp"

namespace enfilade::wire {

namespace {

constexpr std::size_t kMaxSliceCells = 256 * 256;
constexpr std::size_t kMaxRejected = 64;

own::WallDiagnostics_ wall_to_wire(const WallDiagnostics& wall) {
  own::WallDiagnostics_ out;
  out.occupied(wall.occupied);
  out.free(wall.free);
  out.toll(wall.toll);
  out.returns(wall.returns);
  out.moved_m(wall.moved_m);
  return out;
}

WallDiagnostics wall_from_wire(const own::WallDiagnostics_& wall) {
  return {wall.occupied(), wall.free(), wall.toll(), wall.returns(), wall.moved_m()};
}

own::RejectedRectangle_ rejected_to_wire(const RejectedRectangle& rejected) {
  own::RejectedRectangle_ out;
  out.rectangle(to_wire(rejected.rectangle));
  out.score(rejected.score);
  out.reason(rejected.reason);
  return out;
}

RejectedRectangle rejected_from_wire(const own::RejectedRectangle_& rejected) {
  return {from_wire(rejected.rectangle()), rejected.score(), checked(rejected.reason())};
}

own::GapDiagnostics_ gap_to_wire(const GapDiagnostics& gap) {
  own::GapDiagnostics_ out;
  out.gap(to_wire(gap.gap));
  out.verdict(enum_to_wire(gap.verdict));
  out.reason(gap.reason);
  out.occupied_share(gap.occupied_share);
  out.free_share(gap.free_share);
  out.foot_free_share(gap.foot_free_share);
  out.open_nats(gap.open_nats);
  out.from_sigma_m(gap.from_sigma_m);
  out.to_sigma_m(gap.to_sigma_m);
  return out;
}

GapDiagnostics gap_from_wire(const own::GapDiagnostics_& gap) {
  return {.gap = from_wire(gap.gap()),
          .verdict = enum_from_wire(gap.verdict(), GapVerdict::kNoDoor, "the verdict on a gap"),
          .reason = checked(gap.reason()),
          .occupied_share = gap.occupied_share(),
          .free_share = gap.free_share(),
          .foot_free_share = gap.foot_free_share(),
          .open_nats = gap.open_nats(),
          .from_sigma_m = gap.from_sigma_m(),
          .to_sigma_m = gap.to_sigma_m()};
}

own::HoughSlice_ slice_to_wire(const HoughSlice& slice) {
  own::HoughSlice_ out;
  out.yaw_rad(slice.yaw_rad);
  out.origin().x_m(slice.origin.x());
  out.origin().y_m(slice.origin.y());
  out.d_from_m(slice.d_from_m);
  out.p_from_m(slice.p_from_m);
  out.cell_m(slice.cell_m);
  out.columns(slice.columns);
  out.rows(slice.rows);
  out.full_scale(slice.full_scale);
  out.levels(slice.levels);
  return out;
}

HoughSlice slice_from_wire(const own::HoughSlice_& slice) {
  check_count(slice.levels().size(), kMaxSliceCells, "cells of a Hough slice");
  if (static_cast<std::uint64_t>(slice.columns()) * slice.rows() != slice.levels().size())
    throw WireError("a Hough slice does not have columns x rows cells");
  return {.yaw_rad = slice.yaw_rad(),
          .origin = {slice.origin().x_m(), slice.origin().y_m()},
          .d_from_m = slice.d_from_m(),
          .p_from_m = slice.p_from_m(),
          .cell_m = slice.cell_m(),
          .columns = slice.columns(),
          .rows = slice.rows(),
          .full_scale = slice.full_scale(),
          .levels = slice.levels()};
}

}  // namespace

own::RoomDiagnostics_ to_wire(const RoomDiagnostics& diagnostics) {
  own::RoomDiagnostics_ out;
  out.tag(to_wire(diagnostics.tag));
  out.grid_number(diagnostics.grid_sequence);
  out.stamp_ns(diagnostics.stamp_ns);
  out.found(diagnostics.found);
  out.above_furniture(diagnostics.above_furniture);
  out.coarse(to_wire(diagnostics.coarse));
  out.score(diagnostics.score);
  out.score_gap(diagnostics.score_gap);
  for (std::size_t i = 0; i < diagnostics.walls.size(); ++i)
    out.walls()[i] = wall_to_wire(diagnostics.walls[i]);
  out.interior(diagnostics.interior);
  out.slice(slice_to_wire(diagnostics.slice));
  out.rejected(each<own::RejectedRectangle_>(diagnostics.rejected, rejected_to_wire));
  out.gaps(each<own::GapDiagnostics_>(diagnostics.gaps, gap_to_wire));
  return out;
}

RoomDiagnostics from_wire(const own::RoomDiagnostics_& diagnostics) {
  check_count(diagnostics.rejected().size(), kMaxRejected, "rejected rectangles");
  check_count(diagnostics.gaps().size(), kMaxDoors, "gaps");
  RoomDiagnostics out{.tag = from_wire(diagnostics.tag()),
                      .grid_sequence = diagnostics.grid_number(),
                      .stamp_ns = diagnostics.stamp_ns(),
                      .found = diagnostics.found(),
                      .above_furniture = diagnostics.above_furniture(),
                      .coarse = from_wire(diagnostics.coarse()),
                      .score = diagnostics.score(),
                      .score_gap = diagnostics.score_gap(),
                      .walls = {},
                      .interior = diagnostics.interior(),
                      .slice = slice_from_wire(diagnostics.slice()),
                      .rejected = each<RejectedRectangle>(diagnostics.rejected(), rejected_from_wire),
                      .gaps = each<GapDiagnostics>(diagnostics.gaps(), gap_from_wire)};
  for (std::size_t i = 0; i < out.walls.size(); ++i) out.walls[i] = wall_from_wire(diagnostics.walls()[i]);
  return out;
}

}  // namespace enfilade::wire
