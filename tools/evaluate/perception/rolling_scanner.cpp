// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/perception/rolling_scanner.hpp"

#include <cmath>
#include <utility>

#include "components/gridBuilder/core/line_placement.hpp"

namespace enfilade::evaluate {
namespace {

constexpr simulator::BodyConfig kBody;

laser_3d::RolledLine rolled(LaserScan scan, double from_rad, double step_rad) {
  laser_3d::RolledLine line{std::move(scan), {}};
  for (std::size_t i = 0; i < line.scan.ranges_m.size(); ++i) {
    const auto after_ns = static_cast<double>(laser_3d::beam_stamp_ns(line.scan, i) - line.scan.stamp_ns);
    line.roll_rad.push_back(from_rad + step_rad * after_ns / simulator::RangeFinder::kLine_ns);
  }
  return line;
}

}  // namespace

RollingScanner::RollingScanner(const simulator::World& world, const RollingScannerConfig& config,
                               std::uint64_t seed)
    : config_(config),
      scene_(world),
      laser_(config.laser, kBody),
      traffic_(world, kBody.radius_m, kBody.contact_height_m),
      projector_(config.projector),
      random_(seed) {}

std::vector<laser_3d::ProjectedLine> RollingScanner::sweep(const Pose2& T_world_base) {
  constexpr StampNs kLine_ns = simulator::RangeFinder::kLine_ns;
  const double step_rad = radians(config_.line_step_deg);
  std::vector<laser_3d::ProjectedLine> lines;
  for (int i = 0; i <= static_cast<int>(std::lround(kPi / step_rad)); ++i) {
    const double roll_rad = -0.5 * kPi + i * step_rad;
    if (!traffic_.empty()) {
      traffic_.step(seconds(kLine_ns), T_world_base.translation());
      scene_.place_moving(traffic_.positions());
    }
    auto scan = laser_.sense({now_ns_, T_world_base, roll_rad},
                             {now_ns_ + kLine_ns, T_world_base, roll_rad + step_rad}, scene_, random_);
    now_ns_ += kLine_ns;
    if (scan) lines.push_back(projector_.project(rolled(std::move(*scan), roll_rad, step_rad)));
  }
  return lines;
}

ZoneRecorder::Line ZoneRecorder::insert(const laser_3d::ProjectedLine& line, const Point3f& origin_base,
                                        const Pose2& T_zone_base) {
  const StampNs stamp_ns = static_cast<StampNs>(++sequence_) * simulator::RangeFinder::kLine_ns;
  grid_builder::LineUpdate update = grid_.insert(
      grid_builder::place({stamp_ns, true, line.points, line.free_ends}, origin_base, T_zone_base));
  return {{{}, sequence_, stamp_ns, grid_.config().resolution_m, std::move(update.changes)},
          {{}, stamp_ns, T_zone_base, std::move(update.hits)}};
}

}  // namespace enfilade::evaluate
