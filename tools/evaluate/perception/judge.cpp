// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/perception/judge.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace enfilade::evaluate {
namespace {

constexpr double kSameDoorIou = 0.4;
constexpr double kFarFromWall_m = 0.3;
constexpr double kBlindCone_rad = 0.25 * kPi;  // straight behind
const Eigen::Vector3d kMount{0.10, 0.0, 0.60};

using Matrix5 = Eigen::Matrix<double, 5, 5, Eigen::RowMajor>;
using Vector5 = Eigen::Matrix<double, 5, 1>;

bool sees(const Pose2& T_world_base, const Eigen::Vector3d& target, const simulator::RayScene& scene) {
  const Point2 at = T_world_base * Point2(kMount.x(), kMount.y());
  const Eigen::Vector3d origin(at.x(), at.y(), kMount.z()), way = target - origin;
  const Point2 ahead = rotate(-T_world_base.yaw_rad, way.head<2>());
  if (std::acos(-ahead.x() / way.norm()) < kBlindCone_rad) return false;
  const Eigen::Vector3f o = origin.cast<float>(), d = way.normalized().cast<float>();
  const simulator::Ray ray{o.x(), o.y(), o.z(), d.x(), d.y(), d.z()};
  float reach_m = 0.0F;
  scene.cast(std::span(&ray, 1), std::span(&reach_m, 1));
  return static_cast<double>(reach_m) > way.norm() - 1e-3;
}

/// The found rectangle with its sides named like those of the true one.
struct Aligned {
  Rectangle rectangle;
  int quarter_turns = 0;  ///< wall i of the found one is wall i + quarter_turns of the true one
};

Aligned aligned(const Rectangle& found, const Rectangle& truth) {
  const int turns = static_cast<int>(std::lround((found.yaw_rad - truth.yaw_rad) / (0.5 * kPi)));
  Aligned out{found, ((turns % 4) + 4) % 4};
  out.rectangle.yaw_rad = found.yaw_rad - 0.5 * kPi * turns;
  if (turns % 2 != 0) std::swap(out.rectangle.width_m, out.rectangle.height_m);
  return out;
}

/// A gap that was found, along the true wall it lies in; nothing where it lies in none.
std::optional<WallInterval> on_true_wall(const Rectangle& found, const WallInterval& gap,
                                         const Rectangle& truth) {
  const int wall = (gap.wall + aligned(found, truth).quarter_turns) % 4;
  const Segment seen = segment_of(found, gap), line = truth.wall(wall);
  if (std::abs((seen.midpoint() - line.from).dot(truth.normal(wall))) > kFarFromWall_m) return std::nullopt;
  return WallInterval{static_cast<std::uint8_t>(wall), (seen.from - line.from).dot(line.direction()),
                      (seen.to - line.from).dot(line.direction())};
}

bool is_same(const WallInterval& a, const WallInterval& b) {
  return a.wall == b.wall && interval_iou(a.from_m, a.to_m, b.from_m, b.to_m) > kSameDoorIou;
}

}  // namespace

WallInterval gap_of(const Segment& opening, const Rectangle& room) {
  int nearest = 0;
  for (int wall = 1; wall < 4; ++wall) {
    if (distance(opening.midpoint(), room.wall(wall)) < distance(opening.midpoint(), room.wall(nearest)))
      nearest = wall;
  }
  const Segment line = room.wall(nearest);
  const double a = (opening.from - line.from).dot(line.direction()),
               b = (opening.to - line.from).dot(line.direction());
  return {static_cast<std::uint8_t>(nearest), std::min(a, b), std::max(a, b)};
}

double visible_share(const Segment& opening, double height_m, std::span<const Pose2> T_world_base,
                     const simulator::RayScene& scene) {
  constexpr int kAlong = 12, kUp = 8;
  const double from_z = 0.15, to_z = std::min(1.9, height_m - 0.1);
  int seen = 0;
  for (int i = 0; i < kAlong; ++i) {
    for (int k = 0; k < kUp; ++k) {
      const Point2 p = opening.from + (i + 0.5) / kAlong * (opening.to - opening.from);
      const Eigen::Vector3d target(p.x(), p.y(), from_z + (k + 0.5) / kUp * (to_z - from_z));
      seen += std::any_of(T_world_base.begin(), T_world_base.end(),
                          [&](const Pose2& T) { return sees(T, target, scene); });
    }
  }
  return static_cast<double>(seen) / (kAlong * kUp);
}

std::vector<double> size_errors_m(const Rectangle& found, const Rectangle& truth) {
  const Rectangle r = aligned(found, truth).rectangle;
  return {std::abs(r.width_m - truth.width_m), std::abs(r.height_m - truth.height_m)};
}

std::optional<double> nees(const RoomEstimate& estimate, const Rectangle& truth) {
  if (!estimate.covariance) return std::nullopt;
  Matrix5 covariance = Eigen::Map<const Matrix5>(estimate.covariance->data());
  const Aligned found = aligned(estimate.rectangle, truth);
  if (found.quarter_turns % 2 != 0) {
    covariance.row(3).swap(covariance.row(4));
    covariance.col(3).swap(covariance.col(4));
  }
  const Rectangle& r = found.rectangle;
  Vector5 e;
  e << wrap_to_pi(r.yaw_rad - truth.yaw_rad), r.x_m - truth.x_m, r.y_m - truth.y_m, r.width_m - truth.width_m,
      r.height_m - truth.height_m;
  return e.dot(covariance.ldlt().solve(e));
}

DoorTally judge_doors(const RoomEstimate& estimate, const Rectangle& truth,
                      const std::vector<VisibleDoor>& doors) {
  DoorTally tally;
  std::vector<bool> found(doors.size(), false);
  for (const DoorEstimate& door : estimate.doors) {
    if (door.state != DoorState::kOpen) continue;
    ++tally.reported;
    const auto gap = on_true_wall(estimate.rectangle, door.gap, truth);
    for (std::size_t i = 0; gap && i < doors.size(); ++i) {
      if (found[i] || !is_same(*gap, doors[i].gap)) continue;
      found[i] = true;
      ++tally.right;
      tally.edge_errors_m.push_back(std::abs(gap->from_m - doors[i].gap.from_m));
      tally.edge_errors_m.push_back(std::abs(gap->to_m - doors[i].gap.to_m));
      break;
    }
  }
  for (std::size_t i = 0; i < doors.size(); ++i) {
    if (doors[i].visible_share < kLeastVisibleShare) continue;
    ++tally.visible;
    tally.found += found[i];
  }
  return tally;
}

}  // namespace enfilade::evaluate
