// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/stands.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace enfilade::room_detector {
namespace {

constexpr double kJambCell_m = 0.01;

}  // namespace

void Stands::add(const ScanHits& line, double resolution_m) {
  if (!std::isfinite(line.T_zone_base.x_m + line.T_zone_base.y_m + line.T_zone_base.yaw_rad)) return;
  if (is_new_stand(line.T_zone_base)) {
    stands_.push_back({.T_zone_base = line.T_zone_base, .hits = {}, .fine_hits = {}});
    if (stands_.size() > static_cast<std::size_t>(config_.most)) put_oldest_together();
  }
  std::vector<CellHit> at_doors;
  for (const CellHit& hit : line.hits)
    if (hit.z_m >= config_.jamb_from_m && hit.z_m < config_.jamb_to_m) at_doors.push_back(hit);
  followed_ = std::min(followed_, stands_.size() - 1);
  stands_.back().hits.add(line.hits, resolution_m);
  stands_.back().fine_hits.add(at_doors, 2.0 * config_.jamb_to_m, kJambCell_m);
}

bool Stands::is_new_stand(const Pose2& T_zone_base) const {
  if (stands_.empty()) return true;
  const Pose2 moved = stands_.back().T_zone_base.inverse() * T_zone_base;
  return !(moved.translation().norm() <= config_.move_m &&
           std::abs(wrap_to_pi(moved.yaw_rad)) <= radians(config_.turn_deg));
}

void Stands::put_oldest_together() {
  Stand& second = stands_[1];
  stands_[0].hits.add(second.hits);
  stands_[0].fine_hits.add(second.fine_hits);
  ++stands_[0].merged;
  stands_.erase(stands_.begin() + 1);
  followed_ = 0;
}

void Stands::follow(const WallBand& band) {
  if (!(band == band_)) followed_ = 0;
  band_ = band;
  for (; followed_ < stands_.size(); ++followed_) {
    stands_[followed_].hits.follow(band);
    stands_[followed_].wall_points = wall_points(stands_[followed_]);
  }
}

std::vector<WallPoint> Stands::wall_points(const Stand& stand) const {
  const Point2 sensor = stand.T_zone_base * Point2(config_.sensor_forward_m, 0.0);
  std::vector<WallPoint> points;
  points.reserve(stand.hits.columns().size());
  for (const auto& [key, column] : stand.hits.columns()) {
    const Point2 at(column.x_m / column.count, column.y_m / column.count);
    const double up_m = column.z_m / column.count - config_.sensor_height_m;
    const Point2 flat = at - sensor;
    const double range_m = std::hypot(flat.norm(), up_m);
    const bool is_from_one_place = stand.merged == 0 && range_m > 0.0;
    points.push_back({at, column.count, is_from_one_place ? Point2(flat / range_m) : Point2::Zero()});
  }
  return points;
}

}  // namespace enfilade::room_detector
