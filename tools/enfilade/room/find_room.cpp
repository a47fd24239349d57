// SPDX-License-Identifier: Apache-2.0
#include "tools/enfilade/room/find_room.hpp"

#include <cmath>
#include <set>
#include <utility>

#include "tools/enfilade/draw/figures.hpp"
#include "tools/enfilade/room/view.hpp"

namespace enfilade::room {
namespace {

constexpr int kPlanarLayers = 5;  // that the one layer of a level sensor stands for
constexpr double kMargin_m = 1.5, kPoint_px = 5.0;
constexpr double kPictureFrom_m = 0.15, kPictureTo_m = 2.2;  // heights shown

/// The same room with the canonical rectangle, seen from another frame.
RoomEstimate moved(const Pose2& T_file_survey, RoomEstimate estimate) {
  const CanonicalRectangle c = canonical(T_file_survey * estimate.rectangle);
  estimate.rectangle = c.rectangle;
  for (DoorEstimate& door : estimate.doors)
    door.gap.wall = static_cast<std::uint8_t>((door.gap.wall + c.quarter_turns % 4 + 4) % 4);
  return estimate;
}

std::vector<Point2> standing_columns(const Survey& survey) {
  const double r = survey.resolution_m;
  std::set<std::pair<int, int>> columns;
  for (const GridCell& c : survey.cells) {
    const double z_m = (c.z + 0.5) * r;
    if (c.state == CellState::kOccupied && z_m > kPictureFrom_m && z_m < kPictureTo_m)
      columns.emplace(c.x, c.y);
  }
  std::vector<Point2> points;
  for (const auto& [x, y] : columns)
    points.push_back(survey.T_file_survey * Point2((x + 0.5) * r, (y + 0.5) * r));
  return points;
}

/// Votes count cells in whole numbers: one alone could not be weighed against a toll of a twentieth.
void thicken(std::vector<GridCell>& cells) {
  const std::size_t known = cells.size();
  cells.reserve(kPlanarLayers * known);
  for (int layer = 1; layer < kPlanarLayers; ++layer) {
    for (std::size_t i = 0; i < known; ++i) {
      GridCell cell = cells[i];
      cell.z = static_cast<std::int16_t>(cell.z + layer);
      cells.push_back(cell);
    }
  }
}

}  // namespace

room_detector::RoomDetectorConfig planar(room_detector::RoomDetectorConfig config, double resolution_m) {
  const double from_m = planar_layer(resolution_m) * resolution_m;
  const double to_m = from_m + kPlanarLayers * resolution_m;
  config.band.band = room_detector::BandChoice::kUpper;
  config.band.wall_band_from_m = config.door_finder.band_from_m = from_m;
  config.band.wall_band_to_m = config.door_finder.band_to_m = to_m;
  // A cupboard cannot be told from a wall at one height: what stands inside says nothing against a room.
  config.votes.interior_share = 0.0;
  config.door_finder.sill_m = to_m;
  config.door_finder.beyond_floor_m = 0.0;
  return config;
}

FoundRoom find_room(const Survey& survey, const room_detector::RoomDetectorConfig& config,
                    const std::optional<Point2>& at) {
  const Pose2 T_survey_robot =
      at ? survey.T_file_survey.inverse() * Pose2{at->x(), at->y(), 0.0} : survey.T_survey_stand;
  room_detector::RoomDetectorConfig suited = survey.is_planar ? planar(config, survey.resolution_m) : config;
  suited.hough.step_m = std::max(suited.hough.step_m, survey.resolution_m);
  room_detector::RoomDetector detector(suited);
  detector.clear(survey.resolution_m);
  Survey view = survey.is_fused ? seen_from(T_survey_robot.translation(), survey) : survey;
  if (view.is_planar) thicken(view.cells);
  detector.update({.resolution_m = view.resolution_m, .cells = view.cells});
  if (!view.hits.empty()) detector.add_hits({.T_zone_base = T_survey_robot, .hits = view.hits});
  const room_detector::Detection detection = detector.estimate(T_survey_robot);
  FoundRoom found{.estimate = detection.estimate,
                  .T_file_robot = survey.T_file_survey * T_survey_robot,
                  .points = standing_columns(survey)};
  if (found.estimate.found) found.estimate = moved(survey.T_file_survey, found.estimate);
  return found;
}

std::string to_svg(const FoundRoom& room, const std::string& title) {
  return draw::draw_scan({title, room.estimate, room.points, room.T_file_robot, kMargin_m, kPoint_px});
}

}  // namespace enfilade::room
