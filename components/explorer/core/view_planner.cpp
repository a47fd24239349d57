// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/view_planner.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "components/explorer/core/ray_caster.hpp"

namespace enfilade::explorer {
namespace {

constexpr int kHeadings = 8;

bool is_wished(const Pose2& view, const ViewWish& wish) {
  const auto turned = [&](double yaw_rad) { return std::abs(wrap_to_pi(view.yaw_rad - yaw_rad)); };
  if (wish.other_than_yaw_rad && turned(*wish.other_than_yaw_rad) < 0.49 * kPi) return false;
  return std::none_of(wish.had.begin(), wish.had.end(), [&](const Pose2& had) {
    return (had.translation() - view.translation()).norm() < 0.2 && turned(had.yaw_rad) < radians(30.0);
  });
}

/// At most `limit` of them, evenly picked, each worth what those left out would have been.
std::vector<ViewTarget> thinned(const std::vector<ViewTarget>& targets, std::size_t limit) {
  if (targets.size() <= limit) return targets;
  const std::size_t stride = (targets.size() + limit - 1) / limit;
  std::vector<ViewTarget> kept;
  for (std::size_t i = 0; i < targets.size(); i += stride) {
    kept.push_back(targets[i]);
    kept.back().worth_m2 *= static_cast<double>(stride);
  }
  return kept;
}

}  // namespace

bool is_barred(const Point2& place, const std::vector<Point2>& barred) {
  constexpr double kNearM = 0.4;
  return std::any_of(barred.begin(), barred.end(),
                     [&](const Point2& p) { return (p - place).norm() < kNearM; });
}

ViewPlanner::ViewPlanner(const ViewPlannerConfig& config) : config_(config) {
  if (!(config.lattice_m > 0.0) || config.max_places < 1 || config.max_targets < 1) {
    throw std::invalid_argument("ViewPlanner: lattice_m, max_places and max_targets must be greater than 0");
  }
}

std::optional<View> ViewPlanner::best(const ProjectedGrid& grid, const Reach& reach, const Rectangle& area,
                                      const std::vector<ViewTarget>& targets, const Pose2& robot,
                                      const ViewWish& wish) const {
  const auto worth = thinned(targets, static_cast<std::size_t>(config_.max_targets));
  std::optional<View> best;
  double best_rate = 0.0;
  for (const Point2& place : places(reach, area, robot.translation())) {
    if (place != robot.translation() && is_barred(place, wish.barred)) continue;
    const auto seen = visible(grid, place, worth);
    for (int i = 0; i < kHeadings; ++i) {
      View view{.pose = {place.x(), place.y(), wrap_to_pi(robot.yaw_rad + 2.0 * kPi * i / kHeadings)}};
      if (!is_wished(view.pose, wish)) continue;
      for (const ViewTarget& t : seen) view.gain_m2 += in_sight(view.pose, t.at) ? t.worth_m2 : 0.0;
      view.cost_s = cost_s(reach, view.pose, robot);
      const double rate = view.gain_m2 / (config_.sweep_s + view.cost_s);
      if (view.gain_m2 < config_.least_gain_m2 || rate <= best_rate) continue;
      best_rate = rate;
      best = view;
    }
  }
  return best;
}

std::vector<ViewTarget> ViewPlanner::seen_from(const ProjectedGrid& grid, const Pose2& pose,
                                               const std::vector<ViewTarget>& targets) const {
  auto seen = visible(grid, pose.translation(), targets);
  std::erase_if(seen, [&](const ViewTarget& t) { return !in_sight(pose, t.at); });
  return seen;
}

std::vector<Point2> ViewPlanner::places(const Reach& reach, const Rectangle& area,
                                        const Point2& robot) const {
  const double step_m = std::max(config_.lattice_m, std::sqrt(area.area_m2() / config_.max_places));
  std::vector<Point2> places{robot};
  const double half_w = 0.5 * area.width_m - config_.inside_m,
               half_h = 0.5 * area.height_m - config_.inside_m;
  for (double y = -half_h; y <= half_h; y += step_m) {
    for (double x = -half_w; x <= half_w; x += step_m) {
      const auto place = reach.nearest(area.pose() * Point2{x, y}, 0.4 * step_m);
      if (place && (*place - robot).norm() > 0.3 * step_m) places.push_back(*place);
    }
  }
  return places;
}

std::vector<ViewTarget> ViewPlanner::visible(const ProjectedGrid& grid, const Point2& place,
                                             const std::vector<ViewTarget>& targets) const {
  const Eigen::Vector3d eye{place.x(), place.y(), config_.sensor_height_m};
  std::vector<ViewTarget> seen;
  for (const ViewTarget& t : targets) {
    if ((t.at - eye).norm() <= config_.range_m && is_visible(grid, eye, t.at)) seen.push_back(t);
  }
  return seen;
}

bool ViewPlanner::in_sight(const Pose2& pose, const Eigen::Vector3d& at) const {
  const Eigen::Vector3d way = at - Eigen::Vector3d{pose.x_m, pose.y_m, config_.sensor_height_m};
  const Point2 ahead = rotate(pose.yaw_rad, {1.0, 0.0});
  const double forward = (way.x() * ahead.x() + way.y() * ahead.y()) / std::max(1e-6, way.norm());
  return forward > -std::cos(radians(config_.blind_half_angle_deg));
}

double ViewPlanner::cost_s(const Reach& reach, const Pose2& view, const Pose2& robot) const {
  const Point2 way = view.translation() - robot.translation();
  if (way.norm() < 0.05) return std::abs(wrap_to_pi(view.yaw_rad - robot.yaw_rad)) / config_.angular_rad_s;
  const double course = std::atan2(way.y(), way.x());
  const double turn =
      std::abs(wrap_to_pi(course - robot.yaw_rad)) + std::abs(wrap_to_pi(view.yaw_rad - course));
  return reach.cost_m(reach.map().cell_at(view.translation())) / config_.linear_m_s +
         turn / config_.angular_rad_s;
}

}  // namespace enfilade::explorer
