// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/maps/map_evaluation.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "tools/evaluate/maps/plan_rooms.hpp"
#include "tools/evaluate/perception/in_parallel.hpp"
#include "tools/room/find_room.hpp"

namespace enfilade::evaluate {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTruth = "_gt_segmentation.png";

/// What the names of the plans begin with, in order.
std::vector<std::string> plans_in(const std::string& folder) {
  std::vector<std::string> plans;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string file = entry.path().string();
    if (file.ends_with(kTruth)) plans.push_back(file.substr(0, file.size() - std::string(kTruth).size()));
  }
  if (plans.empty())
    throw std::runtime_error(folder + ": holds no *" + kTruth + ": give the folder of the floor plans");
  std::sort(plans.begin(), plans.end());
  return plans;
}

bool is_rectangular(const PlanRoom& room, const MapConfig& config) {
  const auto [shorter, longer] = std::minmax(room.rectangle.width_m, room.rectangle.height_m);
  return room.fill >= config.least_fill && shorter >= config.side_min_m && longer <= config.side_max_m;
}

MapResult evaluate_map(const std::string& plan, bool is_furnished, const MapConfig& config) {
  const std::string file = plan + (is_furnished ? "_furnitures.png" : ".png");
  MapResult result{.name = fs::path(plan).filename().string(), .is_furnished = is_furnished};
  const auto segmentation = simulator::read_grey_image(plan + kTruth),
             image = simulator::read_grey_image(file);
  if (segmentation.columns != image.columns || segmentation.rows != image.rows)
    throw std::runtime_error(file + ": is not of the same size as " + plan + kTruth);
  const auto rooms = plan_rooms(segmentation, image, config.resolution_m);
  for (const PlanRoom& room : rooms) {
    ++result.rooms;
    if (!is_rectangular(room, config)) continue;
    ++result.rectangular;
    for (const Point2& at : room.stands) result.places.push_back({room.rectangle, at, std::nullopt, 0.0});
  }
  const room::Survey survey = room::read_survey(file, {.map_resolution_m = config.resolution_m});
  for (const GridCell& cell : survey.cells)
    if (cell.state == CellState::kOccupied)
      result.walls.push_back(survey.resolution_m * Point2(cell.x + 0.5, cell.y + 0.5));
  in_parallel(static_cast<int>(result.places.size()), [&](int i) {
    MapPlace& place = result.places[static_cast<std::size_t>(i)];
    const RoomEstimate estimate = room::find_room(survey, {}, place.at).estimate;
    if (!estimate.found) return;
    place.found = estimate.rectangle;
    place.iou = iou(estimate.rectangle, place.truth);
  });
  return result;
}

}  // namespace

std::vector<MapResult> evaluate_maps(const std::string& folder, const MapConfig& config) {
  std::vector<MapResult> results;
  for (const std::string& plan : plans_in(folder))
    for (const bool is_furnished : {false, true})
      if (fs::exists(plan + (is_furnished ? "_furnitures.png" : ".png")))
        results.push_back(evaluate_map(plan, is_furnished, config));
  if (results.empty())
    throw std::runtime_error(folder + ": holds none of the plans that its *" + kTruth + " belong to");
  return results;
}

}  // namespace enfilade::evaluate
