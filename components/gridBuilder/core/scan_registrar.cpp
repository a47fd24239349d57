// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/scan_registrar.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "components/gridBuilder/core/wall_alignment.hpp"

namespace enfilade::grid_builder {
namespace {

constexpr std::size_t kLinesBetweenTrials = 5;
constexpr std::size_t kPointsUsed = 4000;  // more add nothing: the walls are no straighter

}  // namespace

ScanRegistrar::ScanRegistrar(const ScanRegistrarConfig& config) : config_(config) {
  if (!(config.to_m > config.from_m) || !(config.last_gate_m > 0.0) ||
      !(config.first_gate_m >= config.last_gate_m) || !(config.sigma_m > 0.0) || config.max_held_lines < 1)
    throw std::invalid_argument(
        "registration: to_m must be above from_m, gates and sigma positive, first_gate_m the wider one, "
        "max_held_lines at least 1");
}

std::vector<PlacedLine> ScanRegistrar::take(PlacedLine line, const std::optional<Rectangle>& walls) {
  std::vector<PlacedLine> ready;
  if (stands_elsewhere(line.T_odom_base)) {
    ready = give_up();
    stand_ = line.T_odom_base;
    model_ = config_.register_scans ? walls : std::nullopt;
  }
  held_.push_back(std::move(line));
  if (model_ && held_.size() % kLinesBetweenTrials == 0) {
    if (const auto correction = register_held()) {
      T_zone_odom_ = *correction * T_zone_odom_;
      model_.reset();
    }
  }
  if (model_ && held_.size() < static_cast<std::size_t>(config_.max_held_lines)) return ready;
  model_.reset();
  for (PlacedLine& settled : held_) ready.push_back(std::move(settled));
  held_.clear();
  return ready;
}

std::vector<PlacedLine> ScanRegistrar::give_up() {
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
  T_zone_odom_ = Pose2{};
}

bool ScanRegistrar::stands_elsewhere(const Pose2& T_odom_base) const {
  if (!stand_) return true;
  const Pose2 moved = stand_->inverse() * T_odom_base;
  return moved.translation().norm() > config_.moved_m ||
         std::abs(wrap_to_pi(moved.yaw_rad)) > radians(config_.moved_deg);
}

std::optional<Pose2> ScanRegistrar::register_held() const {
  std::size_t returns = 0;
  for (const PlacedLine& placed : held_) returns += placed.line.hits.size();
  const std::size_t every = 1 + returns / kPointsUsed;
  std::vector<Point2> points;
  std::size_t i = 0;
  for (const PlacedLine& placed : held_) {
    const Pose2 T_zone_base = T_zone_odom_ * placed.T_odom_base;
    for (const Point3f& p : placed.line.hits) {
      if (i++ % every == 0 && p.z_m >= config_.from_m && p.z_m <= config_.to_m)
        points.push_back(T_zone_base * Point2(p.x_m, p.y_m));
    }
  }
  const Point2 pivot = (T_zone_odom_ * *stand_).translation();
  const auto found = align_to_walls(
      points, *model_, pivot, {config_.first_gate_m, config_.last_gate_m, config_.corner_m, config_.sigma_m});
  const bool is_sure = found && found->sigma_m <= config_.max_sigma_m &&
                       found->sigma_rad <= radians(config_.max_sigma_deg) &&
                       found->on_walls_share >= config_.min_share;
  if (!is_sure) return std::nullopt;
  const Pose2& T = found->T_after_before;
  const bool is_small = (T * pivot - pivot).norm() <= config_.max_shift_m &&
                        std::abs(T.yaw_rad) <= radians(config_.max_turn_deg);
  return is_small ? std::optional(T) : std::nullopt;
}

}  // namespace enfilade::grid_builder
