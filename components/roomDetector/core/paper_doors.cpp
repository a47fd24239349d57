// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/paper_doors.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace enfilade::room_detector {
namespace {

/// H(θ, d, ·), cumulative in p, of all occupied cells: step 2 of the algorithm for one line.
std::vector<int> hough_row(const ColumnMap& map, const HoughLattice& lattice, const Point2& origin,
                           double theta_rad, int d_bin) {
  std::vector<int> row(static_cast<std::size_t>(lattice.bins()), 0);
  for (const Column& column : map.columns()) {
    const Point2 q = rotate(-theta_rad, map.centre(column) - origin);  // (d, p) of eq. 1–2
    const int p_bin = lattice.bin(q.y());
    if (lattice.bin(q.x()) != d_bin || !lattice.holds(p_bin)) continue;
    row[static_cast<std::size_t>(p_bin)] += static_cast<int>(column.occupied.count());
  }
  for (std::size_t p = 1; p < row.size(); ++p) row[p] += row[p - 1];
  return row;
}

void find_in_wall(const ColumnMap& map, const HoughLattice& lattice, const Point2& origin,
                  const Rectangle& rectangle, int wall, const PaperDoorsConfig& config,
                  std::vector<DoorEstimate>& doors) {
  const double theta = rectangle.yaw_rad + 0.5 * kPi * wall;  // step 1: the wall's own θ, so p grows along it
  const Point2 from = rotate(-theta, rectangle.wall(wall).from - origin);  // (d, p_i) of its first corner
  const double half_step = 0.5 * lattice.step_m();
  const int d_d = lattice.bin(from.x());   // step 2
  const int p_di = lattice.bin(from.y());  // step 3
  const int p_dj =
      p_di + static_cast<int>(std::lround(rectangle.wall_length_m(wall) / lattice.step_m()));  // step 4
  const int l_d = static_cast<int>(std::ceil(config.min_length_m / lattice.step_m() - 1e-9));  // step 5
  const std::vector<int> h = hough_row(map, lattice, origin, theta, d_d);
  const auto at = [&h](int p) {
    return p >= 0 && p < static_cast<int>(h.size()) ? h[static_cast<std::size_t>(p)] : 0;
  };
  for (int p_dk = p_di; p_dk <= p_dj - l_d;) {                         // steps 6, 7
    int p_dl = p_dk + 1;                                               // a
    while (p_dl < p_dj && std::abs(at(p_dk) - at(p_dl)) == 0) ++p_dl;  // b, eq. 14
    if (p_dl - p_dk > l_d) {                                           // c
      // Counts up to p_dk and up to p_dl − 1 are equal: the empty bins lie after the one and end with the
      // other, so that the real values (i, ii) are upper bin edges.
      const double p_k = lattice.value_m(p_dk) + half_step, p_l = lattice.value_m(p_dl - 1) + half_step;
      DoorEstimate door;  // iii
      door.gap = {static_cast<std::uint8_t>(wall), p_k - from.y(), p_l - from.y()};
      door.state = DoorState::kOpen;
      doors.push_back(door);  // iv
    }
    p_dk = p_dl;  // d
  }
}

}  // namespace

std::vector<DoorEstimate> find_paper_doors(const ColumnMap& map, const HoughLattice& lattice,
                                           const Point2& origin, const Rectangle& rectangle,
                                           const PaperDoorsConfig& config) {
  std::vector<DoorEstimate> doors;
  for (int wall = 0; wall < 4; ++wall) find_in_wall(map, lattice, origin, rectangle, wall, config, doors);
  return doors;
}

std::vector<DoorEstimate> rename_walls(std::vector<DoorEstimate> doors, const Rectangle& from,
                                       const Rectangle& to) {
  const int quarter_turns = static_cast<int>(std::lround((from.yaw_rad - to.yaw_rad) / (0.5 * kPi)));
  for (DoorEstimate& door : doors) {
    const Segment ends = segment_of(from, door.gap);
    const int wall = (door.gap.wall + quarter_turns + 4) % 4;
    const Segment line = to.wall(wall);
    const auto along_m = [&](const Point2& p) {
      return std::clamp((p - line.from).dot(line.direction()), 0.0, to.wall_length_m(wall));
    };
    door.gap = {static_cast<std::uint8_t>(wall), along_m(ends.from), along_m(ends.to)};
  }
  std::stable_sort(doors.begin(), doors.end(),
                   [](const auto& a, const auto& b) { return a.gap.wall < b.gap.wall; });
  return doors;
}

}  // namespace enfilade::room_detector
