// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <limits>
#include <stdexcept>

#include <yaml-cpp/yaml.h>

#include "interfaces/runtime/read_file.hpp"
#include "tools/room/survey.hpp"
#include "tools/simulator/world/grey_image.hpp"
#include "tools/support/files.hpp"

namespace enfilade::room {
namespace {

/// What a map_server YAML says of its image.
struct MapFrame {
  std::string image;
  double resolution_m = 0.05;
  Pose2 T_map_corner;  ///< lower left corner of the lower left pixel
  bool negate = false;
  double occupied_from = 0.65, free_below = 0.196;
};

MapFrame read_frame(const std::string& file) {
  const std::string text = read_file(file);
  try {
    const YAML::Node yaml = YAML::Load(text);
    if (!yaml.IsMap() || !yaml["image"]) throw std::runtime_error("no image is named in it");
    MapFrame frame;
    const std::filesystem::path image(yaml["image"].as<std::string>());
    frame.image = (image.is_absolute() ? image : std::filesystem::path(file).parent_path() / image).string();
    frame.resolution_m = yaml["resolution"].as<double>();
    const auto origin = yaml["origin"].as<std::vector<double>>();
    if (origin.size() != 3) throw std::runtime_error("origin must be three numbers");
    frame.T_map_corner = {origin[0], origin[1], origin[2]};
    frame.negate = yaml["negate"].as<int>(0) != 0;
    frame.occupied_from = yaml["occupied_thresh"].as<double>(frame.occupied_from);
    frame.free_below = yaml["free_thresh"].as<double>(frame.free_below);
    return frame;
  } catch (const std::exception& error) {
    throw std::runtime_error(file + ": is no map_server map: " + error.what() +
                             "; it needs image, resolution and origin");
  }
}

CellState state_of(std::uint8_t pixel, const MapFrame& frame) {
  const double p = (frame.negate ? pixel : 255 - pixel) / 255.0;
  if (p > frame.occupied_from) return CellState::kOccupied;
  return p < frame.free_below ? CellState::kFree : CellState::kUnexplored;
}

constexpr std::uint8_t kFloor = 230;             // and lighter, in a drawn plan
constexpr std::uint8_t kMapServerUnknown = 205;  // what map_server paints where nothing was seen

/// A drawn plan: white is floor, and where it ends stands something, whatever its grey or how its edge was
/// smoothed; only the grey of map_server's unknown says nothing.
CellState state_in_plan(const simulator::GreyImage& image, int row, int column, const MapFrame& frame) {
  const auto at = [&](int r, int c) { return image.pixels[static_cast<std::size_t>(r) * image.columns + c]; };
  const auto is_floor = [&](int r, int c) {
    return r >= 0 && c >= 0 && r < image.rows && c < image.columns && at(r, c) >= kFloor;
  };
  if (is_floor(row, column)) return CellState::kFree;
  if (at(row, column) == kMapServerUnknown) return CellState::kUnexplored;
  const bool is_edge = is_floor(row - 1, column) || is_floor(row + 1, column) || is_floor(row, column - 1) ||
                       is_floor(row, column + 1);
  return is_edge || state_of(at(row, column), frame) == CellState::kOccupied ? CellState::kOccupied
                                                                             : CellState::kUnexplored;
}

void check(const MapFrame& frame, const simulator::GreyImage& image, const std::string& file) {
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
  const MapFrame frame =
      has_frame ? read_frame(file) : MapFrame{.image = file, .resolution_m = config.map_resolution_m};
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
      const CellState state = has_frame ? state_of(pixel, frame) : state_in_plan(image, row, column, frame);
      if (state == CellState::kUnexplored) continue;
      survey.cells.push_back(grid_builder::to_grid_cell({column, image.rows - 1 - row, layer}, state));
    }
  }
  survey.T_survey_stand = roomiest_place(survey);
  return survey;
}

}  // namespace enfilade::room
