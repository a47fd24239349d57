// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include "tools/simulator/core/occupancy.hpp"
#include "tools/simulator/world/grey_image.hpp"
#include "tools/simulator/world/map_server_frame.hpp"
#include "tools/simulator/world/readers.hpp"

namespace enfilade::simulator {
namespace {

constexpr double kFarthest_m = 1e4;

/// Nothing stands in what is neither occupied nor free, since a wall that nobody has seen cannot be built,
/// but the robot does not start there.
Occupancy occupancy_of(const GreyImage& image, const MapServerFrame& frame) {
  Occupancy occupancy;
  occupancy.columns = image.columns;
  occupancy.rows = image.rows;
  occupancy.resolution_m = frame.resolution_m;
  occupancy.T_world_corner = frame.T_map_corner;
  for (const std::uint8_t pixel : image.pixels) {
    const CellState state = frame.state_of(pixel);
    occupancy.occupied.push_back(state == CellState::kOccupied);
    occupancy.unknown.push_back(state == CellState::kUnexplored);
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

World read_map_server(YamlFields& fields, const std::string& name, const std::string& folder) {
  const MapServerFrame frame = read_map_server_frame(fields, folder, kFarthest_m);
  const ExtrusionConfig extrusion = read_extrusion(fields);
  fields.finish();
  try {
    return extrude(name, occupancy_of(read_grey_image(frame.image), frame), extrusion);
  } catch (const std::runtime_error& e) {
    fields.problem_at("image", e.what());
    return {};
  }
}

}  // namespace enfilade::simulator
