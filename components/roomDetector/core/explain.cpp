// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/explain.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace enfilade::room_detector {
namespace {

constexpr std::uint32_t kSliceCells = 96;  // a side of the picture, at most
constexpr double kSliceMargin_m = 1.0;     // shown around the room
constexpr double kElsewhere_m = 0.3;       // a wall so far away is another one
constexpr double kFarthest_m = 3.0;        // other walls are looked for so far away
constexpr const char* kNames[] = {"wall 2 elsewhere", "wall 0 elsewhere", "wall 3 elsewhere",
                                  "wall 1 elsewhere"};

/// The sides of a BinRectangle in the order of its members: d12 is wall 2 of the rectangle, d34 wall 0, d41
/// wall 3, d23 wall 1.
constexpr int BinRectangle::*kSides[] = {&BinRectangle::d12, &BinRectangle::d34, &BinRectangle::d41,
                                         &BinRectangle::d23};
constexpr int kWallOfSide[] = {2, 0, 3, 1};
/// Which of h₁₂, h₂₃, h₃₄, h₄₁ belongs to it.
constexpr int kTermOfSide[] = {0, 2, 3, 1};

bool is_on_side(const BinRectangle& r, int side, const HoughSpace::Bins& b) {
  switch (side) {  // eq. 6–9: each wall includes its first corner and excludes its last
    case 0:
      return b.d == r.d12 && b.p >= r.d41 && b.p < r.d23;
    case 1:
      return b.d == r.d34 && b.p > r.d41 && b.p <= r.d23;
    case 2:
      return b.p == r.d41 && b.d > r.d12 && b.d <= r.d34;
    default:
      return b.p == r.d23 && b.d >= r.d12 && b.d < r.d34;
  }
}

int length_in_bins(const BinRectangle& r, int side) { return side < 2 ? r.d23 - r.d41 : r.d34 - r.d12; }

void explain_walls(const Decision& decision, RoomDiagnostics& out) {
  const BinRectangle& r = decision.search.rectangle;
  std::array<int, 4> occupied{};
  for (const Vote& vote : decision.space.votes()) {
    if (vote.occupied == 0) continue;
    const auto bins = decision.space.bins_of(r.alpha, vote.position);
    for (int side = 0; side < 4; ++side)
      if (is_on_side(r, side, bins)) occupied[static_cast<std::size_t>(side)] += vote.occupied;
  }
  double walls = 0.0, tolls = 0.0;
  for (std::size_t side = 0; side < 4; ++side) {
    const int term = decision.search.walls[static_cast<std::size_t>(kTermOfSide[side])];
    WallDiagnostics& wall = out.walls[static_cast<std::size_t>(kWallOfSide[side])];
    wall.occupied = occupied[side] / decision.unit;
    wall.free = (term - occupied[side]) / decision.unit;
    wall.toll =
        -decision.space.penalties().per_bin * length_in_bins(r, static_cast<int>(side)) / decision.unit;
    walls += term / decision.unit;
    tolls += wall.toll;
  }
  out.interior = out.score - walls - tolls;
}

bool is_rectangle(const BinRectangle& r, const HoughLattice& lattice) {
  return r.d12 < r.d34 && r.d41 < r.d23 && lattice.holds(r.d12) && lattice.holds(r.d34) &&
         lattice.holds(r.d41) && lattice.holds(r.d23);
}

/// The best rectangle that has one side elsewhere, the others held.
std::optional<RejectedRectangle> best_other(const Decision& decision, int side) {
  const HoughLattice& lattice = decision.space.lattice();
  const int near = static_cast<int>(std::ceil(kElsewhere_m / lattice.step_m()));
  const int far = static_cast<int>(kFarthest_m / lattice.step_m());
  const int stride = std::max(1, near / 6);
  std::optional<RejectedRectangle> best;
  for (int by = -far; by <= far; by += stride) {
    if (std::abs(by) < near) continue;
    BinRectangle other = decision.search.rectangle;
    other.*kSides[side] += by;
    if (!is_rectangle(other, lattice)) continue;
    const double score = decision.space.score(other) / decision.unit;
    if (best && score <= best->score) continue;
    best = RejectedRectangle{decision.space.rectangle(other), score, kNames[side]};
  }
  return best;
}

void draw_slice(const Decision& decision, RoomDiagnostics& out) {
  const HoughLattice& lattice = decision.space.lattice();
  const BinRectangle& r = decision.search.rectangle;
  HoughSlice& slice = out.slice;
  slice.yaw_rad = lattice.alpha_rad(r.alpha);
  slice.origin = decision.space.origin();
  slice.d_from_m = lattice.value_m(r.d12) - kSliceMargin_m;
  slice.p_from_m = lattice.value_m(r.d41) - kSliceMargin_m;
  const double wide = (r.d34 - r.d12) * lattice.step_m() + 2.0 * kSliceMargin_m;
  const double high = (r.d23 - r.d41) * lattice.step_m() + 2.0 * kSliceMargin_m;
  slice.cell_m = std::max(lattice.step_m(), std::max(wide, high) / kSliceCells);
  slice.columns = std::min(kSliceCells, static_cast<std::uint32_t>(std::ceil(wide / slice.cell_m)));
  slice.rows = std::min(kSliceCells, static_cast<std::uint32_t>(std::ceil(high / slice.cell_m)));
  std::vector<double> votes(static_cast<std::size_t>(slice.columns) * slice.rows, 0.0);
  for (const Vote& vote : decision.space.votes()) {
    if (vote.occupied == 0) continue;
    const Point2 q = rotate(-slice.yaw_rad, vote.position - slice.origin);
    const double column = std::floor((q.x() - slice.d_from_m) / slice.cell_m),
                 row = std::floor((q.y() - slice.p_from_m) / slice.cell_m);
    if (column < 0.0 || row < 0.0 || column >= slice.columns || row >= slice.rows) continue;
    votes[static_cast<std::size_t>(row) * slice.columns + static_cast<std::size_t>(column)] +=
        vote.occupied / decision.unit;
  }
  if (votes.empty()) return;
  slice.full_scale = *std::max_element(votes.begin(), votes.end());
  for (const double v : votes)
    slice.levels.push_back(
        static_cast<std::uint8_t>(slice.full_scale > 0.0 ? std::lround(255.0 * v / slice.full_scale) : 0));
}

}  // namespace

void explain_score(const Decision& decision, RoomDiagnostics& out) {
  out.score = decision.search.score / decision.unit;
  out.score_gap = decision.search.gap / decision.unit;
  out.coarse = decision.space.rectangle(decision.search.rectangle);
  explain_walls(decision, out);
  for (int side = 0; side < 4; ++side)
    if (auto other = best_other(decision, side)) out.rejected.push_back(std::move(*other));
  draw_slice(decision, out);
}

void explain_fit(const RectangleFit& fit, const Rectangle& coarse, RoomDiagnostics& out) {
  for (int wall = 0; wall < 4; ++wall) {
    WallDiagnostics& w = out.walls[static_cast<std::size_t>(wall)];
    w.returns = fit.support[static_cast<std::size_t>(wall)];
    w.moved_m = (fit.rectangle.wall(wall).midpoint() - coarse.wall(wall).midpoint()).dot(coarse.normal(wall));
  }
}

}  // namespace enfilade::room_detector
