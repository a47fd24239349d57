// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <stdexcept>

#include "tools/simulator/core/occupancy.hpp"
#include "tools/simulator/world/grey_image.hpp"
#include "tools/simulator/world/readers.hpp"

namespace enfilade::simulator {
namespace {

constexpr double kFarthest_m = 1e4;

/// As map_server has it: p = (255 - pixel) / 255, or pixel / 255 when negated; occupied where p exceeds the
/// threshold. What is neither occupied nor free is taken for free: a wall that nobody has seen cannot be
/// built.
Occupancy threshold(const GreyImage& image, bool negate, double occupied_threshold) {
  Occupancy occupancy;
  occupancy.columns = image.columns;
  occupancy.rows = image.rows;
  for (const std::uint8_t pixel : image.pixels)
    occupancy.occupied.push_back((negate ? pixel : 255 - pixel) / 255.0 > occupied_threshold);
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
  const double occupied_threshold = fields.number_or("occupied_thresh", 0.65, 0.0, 1.0);
  fields.number_or("free_thresh", 0.25, 0.0, 1.0);
  fields.text_or("mode", "trinary");
  const ExtrusionConfig extrusion = read_extrusion(fields);
  fields.finish();
  if (origin.empty()) return {};
  try {
    const auto file = image_path.is_absolute() ? image_path : std::filesystem::path(folder) / image_path;
    Occupancy occupancy = threshold(read_grey_image(file.string()), negate, occupied_threshold);
    occupancy.resolution_m = resolution_m;
    occupancy.T_world_corner = {origin[0], origin[1], origin[2]};
    return extrude(name, occupancy, extrusion);
  } catch (const std::runtime_error& e) {
    fields.problem_at("image", e.what());
    return {};
  }
}

}  // namespace enfilade::simulator
