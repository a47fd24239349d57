// SPDX-License-Identifier: Apache-2.0
#include "interfaces/convert/grid.hpp"

#include <cmath>

namespace enfilade::wire {

namespace {

own::GridCell_ cell_to_wire(const GridCell& cell) {
  own::GridCell_ out;
  out.x(cell.x);
  out.y(cell.y);
  out.z(cell.z);
  out.state(enum_to_wire(cell.state));
  return out;
}

GridCell cell_from_wire(const own::GridCell_& cell) {
  return {cell.x(), cell.y(), cell.z(),
          enum_from_wire(cell.state(), CellState::kOccupied, "the state of a cell")};
}

own::CellHit_ hit_to_wire(const CellHit& hit) {
  own::CellHit_ out;
  out.x_m(hit.x_m);
  out.y_m(hit.y_m);
  out.z_m(hit.z_m);
  out.count(hit.count);
  return out;
}

CellHit hit_from_wire(const own::CellHit_& hit) {
  if (hit.count() == 0) throw WireError("a cell was hit by 0 returns");
  return {hit.x_m(), hit.y_m(), hit.z_m(), hit.count()};
}

double resolution_from_wire(double resolution_m) {
  if (!std::isfinite(resolution_m) || resolution_m <= 0.0)
    throw WireError("the resolution of a grid is " + std::to_string(resolution_m) + " m");
  return resolution_m;
}

}  // namespace

own::GridChange_ to_wire(const GridChange& change) {
  own::GridChange_ out;
  out.tag(to_wire(change.tag));
  out.number(change.sequence);
  out.stamp_ns(change.stamp_ns);
  out.resolution_m(change.resolution_m);
  out.cells(each<own::GridCell_>(change.cells, cell_to_wire));
  return out;
}

GridChange from_wire(const own::GridChange_& change) {
  check_count(change.cells().size(), kMaxGridCells, "grid cells");
  return {from_wire(change.tag()), change.number(), change.stamp_ns(),
          resolution_from_wire(change.resolution_m()), each<GridCell>(change.cells(), cell_from_wire)};
}

own::ScanHits_ to_wire(const ScanHits& hits) {
  own::ScanHits_ out;
  out.tag(to_wire(hits.tag));
  out.stamp_ns(hits.stamp_ns);
  out.pose_zone_base(to_wire(hits.T_zone_base));
  out.hits(each<own::CellHit_>(hits.hits, hit_to_wire));
  return out;
}

ScanHits from_wire(const own::ScanHits_& hits) {
  check_count(hits.hits().size(), kMaxCellHits, "cell hits");
  return {from_wire(hits.tag()), hits.stamp_ns(), from_wire(hits.pose_zone_base()),
          each<CellHit>(hits.hits(), hit_from_wire)};
}

}  // namespace enfilade::wire
