// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <limits>
#include <stdexcept>

#include <yaml-cpp/yaml.h>

#include "interfaces/runtime/read_file.hpp"
#include "tools/room/survey.hpp"
#include "tools/simulator/world/grey_image.hpp"
#include "tools/simulator/world/map_server_frame.hpp"
#include "tools/support/files.hpp"

namespace enfilade::room {
namespace {

using simulator::MapServerFrame;

constexpr double kFarthestOrigin_m = 1e7;  // maps of the land have such coordinates

MapServerFrame read_frame(const std::string& file) {
  const std::string text = read_file(file);
  try {
    const YAML::Node yaml = YAML::Load(text);
    if (!yaml.IsMap() || !yaml["image"])
      throw std::runtime_error(file + ":1: is no map_server map: it needs image, resolution and origin");
    simulator::YamlProblems problems(file);
    simulator::YamlFields fields(yaml, "", problems);
    const std::string folder = std::filesystem::path(file).parent_path().string();
    MapServerFrame frame = simulator::read_map_server_frame(fields, folder, kFarthestOrigin_m);
    problems.throw_if_any();
    return frame;
  } catch (const YAML::Exception& e) {
    throw std::runtime_error(file + ":" + std::to_string(e.mark.line + 1) + ": not YAML (" + e.msg +
                             "): mend this line");
  }
}

constexpr std::uint8_t kFloor = 230;             // and lighter, in a drawn plan
constexpr std::uint8_t kMapServerUnknown = 205;  // what map_server paints where nothing was seen

/// A drawn plan: white is floor, and where it ends stands something, whatever its grey or how its edge was
/// smoothed; only the grey of map_server's unknown says nothing.
CellState state_in_plan(const simulator::GreyImage& image, int row, int column, const MapServerFrame& frame) {
  const auto at = [&](int r, int c) { return image.pixels[static_cast<std::size_t>(r) * image.columns + c]; };
  const auto is_floor = [&](int r, int c) {
    return r >= 0 && c >= 0 && r < image.rows && c < image.columns && at(r, c) >= kFloor;
  };
  if (is_floor(row, column)) return CellState::kFree;
  if (at(row, column) == kMapServerUnknown) return CellState::kUnexplored;
  const bool is_edge = is_floor(row - 1, column) || is_floor(row + 1, column) || is_floor(row, column - 1) ||
                       is_floor(row, column + 1);
  return is_edge || frame.state_of(at(row, column)) == CellState::kOccupied ? CellState::kOccupied
                                                                            : CellState::kUnexplored;
}

void check(const MapServerFrame& frame, const simulator::GreyImage& image, const std::string& file) {
  constexpr int kMost = std::numeric_limits<std::int16_t>::max();
  if (!(frame.resolution_m >= 0.01 && frame.resolution_m <= 1.0))
    throw std::runtime_error(file + ": its resolution must lie in 0.01 … 1 m a pixel");
  if (image.columns > kMost || image.rows > kMost)
    throw std::runtime_error(file + ": is wider or higher than 32767 pixels: give a part of it");
}

}  // namespace

/// The survey's frame has its origin in the image's lower left corner, so that cells are pixels.
Survey survey_of_map(const std::string& file, const SurveyConfig& config) {
  const bool has_frame = ending_of(file) == ".yaml";
  const MapServerFrame frame =
      has_frame ? read_frame(file) : MapServerFrame{.image = file, .resolution_m = config.map_resolution_m};
  const simulator::GreyImage image = simulator::read_grey_image(frame.image);
  check(frame, image, file);
  Survey survey{.resolution_m = frame.resolution_m,
                .is_fused = true,
                .is_planar = true,
                .T_file_survey = frame.T_map_corner};
  const int layer = planar_layer(frame.resolution_m);
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.columns; ++column) {
      const auto pixel = image.pixels[static_cast<std::size_t>(row) * image.columns + column];
      const CellState state = has_frame ? frame.state_of(pixel) : state_in_plan(image, row, column, frame);
      if (state == CellState::kUnexplored) continue;
      survey.cells.push_back(grid_builder::to_grid_cell({column, image.rows - 1 - row, layer}, state));
    }
  }
  survey.T_survey_stand = roomiest_place(survey);
  return survey;
}

}  // namespace enfilade::room
