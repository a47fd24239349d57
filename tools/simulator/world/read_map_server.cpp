// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <stdexcept>

#include "tools/simulator/core/occupancy.hpp"
#include "tools/simulator/world/grey_image.hpp"
#include "tools/simulator/world/readers.hpp"

namespace enfilade::simulator {
namespace {

constexpr double kFarthest_m = 1e4;

struct Thresholds {
  double occupied = 0.65, free = 0.25;
};

/// As map_server has it: p = (255 - pixel) / 255, or pixel / 255 when negated; occupied where p exceeds the
/// upper threshold, free where it is below the lower one. Nothing stands in what is neither, since a wall
/// that nobody has seen cannot be built, but the robot does not start there.
Occupancy threshold(const GreyImage& image, bool negate, const Thresholds& thresholds) {
  Occupancy occupancy;
  occupancy.columns = image.columns;
  occupancy.rows = image.rows;
  for (const std::uint8_t pixel : image.pixels) {
    const double p = (negate ? pixel : 255 - pixel) / 255.0;
    occupancy.occupied.push_back(p > thresholds.occupied);
    occupancy.unknown.push_back(p <= thresholds.occupied && p >= thresholds.free);
  }
  return occupancy;
}

ExtrusionConfig read_extrusion(YamlFields& fields) {
  ExtrusionConfig config;
  config.wall_height_m = fields.number_or("wall_height_m", 2.5, 0.1, 20.0);
  if (fields.has("ceiling_m")) config.ceiling_m = fields.number("ceiling_m", 0.5, 20.0);
  fields.node("ceiling_m");
  if (auto start = fields.group("start")) {
    config.T_world_start = Pose2{start->number("x_m", -kFarthest_m, kFarthest_m),
                                 start->number("y_m", -kFarthest_m, kFarthest_m),
                                 radians(start->number_or("yaw_deg", 0.0, -360.0, 360.0))};
    start->finish();
  }
  return config;
}

}  // namespace

World read_map_server(YamlFields& fields, const std::string& name, const std::string& folder, YamlProblems&) {
  const std::filesystem::path image_path(fields.text("image"));
  const double resolution_m = fields.number("resolution", 1e-3, 10.0);
  const std::vector<double> origin = fields.numbers("origin", 3, -kFarthest_m, kFarthest_m);
  const bool negate = fields.number_or("negate", 0.0, 0.0, 1.0) > 0.5;
  const Thresholds thresholds{.occupied = fields.number_or("occupied_thresh", 0.65, 0.0, 1.0),
                              .free = fields.number_or("free_thresh", 0.25, 0.0, 1.0)};
  fields.text_or("mode", "trinary");
  const ExtrusionConfig extrusion = read_extrusion(fields);
  fields.finish();
  if (origin.empty()) return {};
  try {
    const auto file = image_path.is_absolute() ? image_path : std::filesystem::path(folder) / image_path;
    Occupancy occupancy = threshold(read_grey_image(file.string()), negate, thresholds);
    occupancy.resolution_m = resolution_m;
    occupancy.T_world_corner = {origin[0], origin[1], origin[2]};
    return extrude(name, occupancy, extrusion);
  } catch (const std::runtime_error& e) {
    fields.problem_at("image", e.what());
    return {};
  }
}

}  // namespace enfilade::simulator
