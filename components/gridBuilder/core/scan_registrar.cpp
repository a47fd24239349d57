// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/scan_registrar.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace enfilade::grid_builder {
namespace {

constexpr std::size_t kLinesBetweenTrials = 5;
constexpr std::size_t kPointsUsed = 4000;  // more add nothing: the walls are no straighter

}  // namespace

ScanRegistrar::ScanRegistrar(const ScanRegistrarConfig& config) : config_(config), drift_(config.drift) {
  if (!(config.to_m > config.from_m) || !(config.last_gate_m > 0.0) ||
      !(config.first_gate_m >= config.last_gate_m) || !(config.sigma_m > 0.0) || config.max_held_lines < 1)
    throw std::invalid_argument(
        "registration: to_m must be above from_m, gates and sigma positive, first_gate_m the wider one, "
        "max_held_lines at least 1");
}

void ScanRegistrar::move(const Pose2& T_odom_base) {
  if (config_.register_scans) drift_.move(T_odom_base);
}

std::vector<PlacedLine> ScanRegistrar::take(PlacedLine line, const std::optional<KnownWalls>& walls) {
  std::vector<PlacedLine> ready;
  if (stands_elsewhere(line.T_odom_base)) {
    ready = release();
    arrive(line.T_odom_base, walls);
  }
  held_.push_back(std::move(line));
  const bool is_last = held_.size() >= static_cast<std::size_t>(config_.max_held_lines);
  if (model_ && (is_last || held_.size() % kLinesBetweenTrials == 0)) settle(is_last);
  if (model_ && !is_last) return ready;
  for (PlacedLine& settled : release()) ready.push_back(std::move(settled));
  return ready;
}

void ScanRegistrar::arrive(const Pose2& T_odom_base, const std::optional<KnownWalls>& walls) {
  stand_ = T_odom_base;
  if (!config_.register_scans) return;
  drift_.move(T_odom_base);
  model_ = walls;
  if (!walls) drift_.begin_here();
}

/// Takes the place that walls tell once they tell all of it, or when nothing more is to come: what they do
/// not tell, odometry does.
void ScanRegistrar::settle(bool is_last) {
  const auto found = register_held();
  if (!found || found->on_walls_share < config_.min_share) return;
  const bool is_sure =
      found->sigma_m <= config_.max_sigma_m && found->sigma_rad <= radians(config_.max_sigma_deg);
  if ((is_sure || is_last) && drift_.settle(found->T_after_before, found->covariance)) model_.reset();
}

std::vector<PlacedLine> ScanRegistrar::finish() {
  if (model_ && !held_.empty()) settle(true);
  return release();
}

std::vector<PlacedLine> ScanRegistrar::release() {
  model_.reset();
  return std::exchange(held_, {});
}

void ScanRegistrar::forget_lines() {
  held_.clear();
  stand_.reset();
  model_.reset();
}

void ScanRegistrar::forget_odometry() {
  forget_lines();
  drift_.forget_odometry();
}

bool ScanRegistrar::stands_elsewhere(const Pose2& T_odom_base) const {
  if (!stand_) return true;
  const Pose2 moved = stand_->inverse() * T_odom_base;
  return moved.translation().norm() > config_.moved_m ||
         std::abs(wrap_to_pi(moved.yaw_rad)) > radians(config_.moved_deg);
}

std::vector<Point2> ScanRegistrar::held_points() const {
  std::size_t returns = 0;
  for (const PlacedLine& placed : held_) returns += placed.line.hits.size();
  const std::size_t every = 1 + returns / kPointsUsed;
  std::vector<Point2> points;
  std::size_t i = 0;
  for (const PlacedLine& placed : held_) {
    const Pose2 T_zone_base = T_zone_odom() * placed.T_odom_base;
    for (const Point3f& p : placed.line.hits) {
      if (i++ % every == 0 && p.z_m >= config_.from_m && p.z_m <= config_.to_m)
        points.push_back(T_zone_base * Point2(p.x_m, p.y_m));
    }
  }
  return points;
}

std::optional<WallAlignment> ScanRegistrar::register_held() const {
  const double may_be_turned_rad = config_.drift.gate_sigma * std::sqrt(drift_.covariance()(2, 2));
  return align_to_walls(held_points(), *model_, (T_zone_odom() * *stand_).translation(),
                        {.first_gate_m = config_.first_gate_m,
                         .last_gate_m = config_.last_gate_m,
                         .corner_m = config_.corner_m,
                         .sigma_m = config_.sigma_m,
                         .search_rad = may_be_turned_rad});
}

}  // namespace enfilade::grid_builder
