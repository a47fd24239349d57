// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "tools/evaluate/graph/graph_evaluation.hpp"
#include "tools/launch/composed_run.hpp"

namespace enfilade::evaluate {

std::optional<PoseErrors> explore_ring4(const std::string& world) {
  // True wheels that are 3 % larger than odometry takes them to be: every way and every turn comes out long.
  const ComposedRunOptions options{
      .world = world,
      .seed = 1,
      .settings = Settings({"simulator.drive.left_radius_scale=1.03",
                            "simulator.drive.right_radius_scale=1.03", "simulator.drive.track_scale=1.0"})};
  const report::Report report = run_composed(options);
  if (!report.record.finished() || report.evaluation.rooms.size() != 4) return std::nullopt;
  PoseErrors errors;
  for (const report::RoomReport& room : report.evaluation.rooms) {
    if (!room.truth) return std::nullopt;
    const double off_m = std::hypot(room.measured.x_m - room.truth->x_m, room.measured.y_m - room.truth->y_m);
    errors.max_m = std::max(errors.max_m, off_m);
    errors.max_rad =
        std::max(errors.max_rad, std::abs(wrap_to_quarter(room.measured.yaw_rad - room.truth->yaw_rad)));
  }
  return errors;
}

}  // namespace enfilade::evaluate
