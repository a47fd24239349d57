// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/perception/range_calibration.hpp"

#include <cmath>
#include <functional>

#include "components/laser3D/core/replay_cloud.hpp"
#include "components/roomDetector/core/room_detector.hpp"
#include "tools/evaluate/perception/rolling_scanner.hpp"
#include "tools/simulator/core/floor_plan.hpp"

namespace enfilade::evaluate {
namespace {

constexpr int kIterations = 3;      // the fit is robust, so the side is not quite linear in the bias
constexpr double kNearest_m = 0.5;  // a side farther from the true one is another one

/// One side of the room, and what a range bias of 1 m adds to it.
struct Side {
  double length_m, per_bias, sigma_m;
};

std::optional<Side> side_near(const room_detector::Detection& d, double width_m) {
  if (!d.estimate.found || !d.diagnostics.fit) return std::nullopt;
  const room_detector::RectangleFit& fit = *d.diagnostics.fit;
  const Rectangle& r = fit.rectangle;
  const int side = std::abs(r.width_m - width_m) <= std::abs(r.height_m - width_m) ? 3 : 4;
  const double length = side == 3 ? r.width_m : r.height_m;
  if (std::abs(length - width_m) > kNearest_m || !(fit.per_range_bias[side] > 0.1)) return std::nullopt;
  return Side{length, fit.per_range_bias[side], std::sqrt(fit.covariance(side, side))};
}

/// `measure(bias)`: the side with this bias taken off every range.
std::optional<RangeCalibration> solve(const std::function<std::optional<Side>(double)>& measure,
                                      double width_m) {
  RangeCalibration result;
  for (int i = 0; i <= kIterations; ++i) {
    const auto side = measure(result.bias_m);
    if (!side) return std::nullopt;
    if (i == 0) result.measured_m = side->length_m;
    result.corrected_m = side->length_m;
    if (i == kIterations) break;
    result.bias_m += (side->length_m - width_m) / side->per_bias;
    result.sigma_m = side->sigma_m / side->per_bias;
  }
  return result;
}

room_detector::RoomDetectorConfig detector_config() {
  room_detector::RoomDetectorConfig config;
  config.joint.range_bias_sigma_m = 0.0;  // that is what is looked for
  return config;
}

class Listener {
 public:
  Listener() : recorder_({}), detector_(detector_config()) {
    detector_.clear(grid_builder::ZoneGridConfig{}.resolution_m);
  }
  void take(const laser_3d::ProjectedLine& line, const Point3f& origin_base, const Pose2& T_zone_base) {
    const ZoneRecorder::Line recorded = recorder_.insert(line, origin_base, T_zone_base);
    detector_.update(recorded.change);
    detector_.add_hits(recorded.hits);
  }
  room_detector::Detection look(const Pose2& T_zone_base) { return detector_.estimate(T_zone_base); }

 private:
  ZoneRecorder recorder_;
  room_detector::RoomDetector detector_;
};

laser_3d::ScannedPoints shortened(laser_3d::ScannedPoints cloud, double by_m) {
  for (Point3f& p : cloud.points) {
    const double x = p.x_m - cloud.origin.x_m, y = p.y_m - cloud.origin.y_m, z = p.z_m - cloud.origin.z_m;
    const double range = std::hypot(x, y, z);
    const double share = range > by_m ? 1.0 - by_m / range : 1.0;
    p = {static_cast<float>(cloud.origin.x_m + share * x), static_cast<float>(cloud.origin.y_m + share * y),
         static_cast<float>(cloud.origin.z_m + share * z)};
  }
  return cloud;
}

simulator::World bare_room(double width_m) {
  simulator::FloorPlan plan;
  plan.name = "calibration";
  plan.rooms.push_back({"room", {0.0, 0.0, 0.0, width_m, 1.2 * width_m}, 2.6, 0});
  plan.T_building_start = {0.1 * width_m, -0.15 * width_m, 0.3};
  return simulator::build_world(plan);
}

}  // namespace

std::optional<RangeCalibration> calibrate_range(const laser_3d::ScannedPoints& cloud, double width_m) {
  return solve(
      [&](double bias_m) -> std::optional<Side> {
        const auto replay = laser_3d::make_replay_cloud({}, shortened(cloud, bias_m));
        if (!replay) return std::nullopt;
        Listener listener;
        const Point3f origin{0.0F, 0.0F, static_cast<float>(replay->scanner_height_m)};
        for (std::size_t i = 0; i < replay->lines.size(); ++i)
          listener.take({replay->lines[i], replay->free_ends[i], {}}, origin, {});
        return side_near(listener.look({}), width_m);
      },
      width_m);
}

std::optional<RangeCalibration> calibrate_simulated_range(double width_m, double true_bias_m,
                                                          std::uint64_t seed) {
  const simulator::World world = bare_room(width_m);
  return solve(
      [&](double bias_m) {
        RollingScannerConfig config;
        config.laser.bias_m = true_bias_m;
        config.projector.range_bias_m = bias_m;
        RollingScanner scanner(world, config, seed);
        Listener listener;
        const laser_3d::ScanProjectorConfig& mount = config.projector;
        const Point3f origin{static_cast<float>(mount.mount_x_m), static_cast<float>(mount.mount_y_m),
                             static_cast<float>(mount.mount_z_m)};
        Pose2 T_zone_base;
        for (int i = 0; i < 2; ++i) {
          T_zone_base = {0.0, 0.0, kPi * i};
          const Pose2 T_world_base = world.truth.T_world_start * T_zone_base;
          for (const auto& line : scanner.sweep(T_world_base)) listener.take(line, origin, T_zone_base);
        }
        return side_near(listener.look(T_zone_base), width_m);
      },
      width_m);
}

}  // namespace enfilade::evaluate
