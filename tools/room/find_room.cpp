// SPDX-License-Identifier: Apache-2.0
#include "tools/room/find_room.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <set>
#include <utility>

#include "tools/draw/figures.hpp"
#include "tools/room/outline_choice.hpp"
#include "tools/room/view.hpp"

namespace enfilade::room {
namespace {

constexpr int kPlanarLayers = 5;  // that the one layer of a level sensor stands for

// In one layer a cupboard cannot be told from a wall, and a room with the corridor behind its open door is
// bounded like one room: there is no lintel. How much should be held against a rectangle, unseen outline and
// things inside, differs from building to building: each of these gives a proposal, from strict to such as
// forgive many open doors. Factors on the weights of the configuration.
struct Strictness {
  double toll, interior, free;
};
constexpr Strictness kPlanarStrictness[] = {
    {6.0, 4.0, 1.0}, {6.0, 1.0, 1.0}, {1.0, 0.0, 1.0}, {1.0, 0.0, 0.5}};

constexpr int kReturnsPerFace =
    20;  // that each sight of a map stands for: what is behind the face counts less

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

/// Where walls of a map begin, as if measured.
std::vector<CellHit> faces_seen(const Panorama& panorama) {
  const auto z_m = static_cast<float>((planar_layer(panorama.resolution_m) + 0.5) * panorama.resolution_m);
  std::vector<CellHit> faces;
  for (const Sight& sight : panorama.sights) {
    const Point2 at = panorama.end_of(sight);
    if (sight.meets)
      faces.push_back({static_cast<float>(at.x()), static_cast<float>(at.y()), z_m, kReturnsPerFace});
  }
  return faces;
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

/// One for each proposal.
std::vector<room_detector::RoomDetectorConfig> suited_to(const Survey& survey,
                                                         room_detector::RoomDetectorConfig config) {
  config.hough.step_m = std::max(config.hough.step_m, survey.resolution_m);
  // A file can wait longer than a scan line.
  config.search.max_expansions = std::max(config.search.max_expansions, room_detector::kPatientExpansions);
  if (!survey.is_planar) return {config};
  config = planar(config, survey.resolution_m);
  std::vector<room_detector::RoomDetectorConfig> configs;
  for (const Strictness& strictness : kPlanarStrictness) {
    auto& votes = configs.emplace_back(config).votes;
    votes.toll_share *= strictness.toll;
    votes.interior_share *= strictness.interior;
    votes.free_weight *= strictness.free;
  }
  return configs;
}

room_detector::RoomDetector detector_of(const Survey& view, const Pose2& T_survey_robot,
                                        const room_detector::RoomDetectorConfig& config) {
  room_detector::RoomDetector detector(config);
  detector.clear(view.resolution_m);
  detector.update({.resolution_m = view.resolution_m, .cells = view.cells});
  if (!view.hits.empty()) detector.add_hits({.T_zone_base = T_survey_robot, .hits = view.hits});
  return detector;
}

/// The most plausible outline of all that the proposals suggest.
RoomEstimate find_planar(const Survey& view, const Pose2& T_survey_robot,
                         const std::vector<room_detector::RoomDetectorConfig>& configs) {
  std::deque<room_detector::RoomDetector> detectors;
  std::vector<RoomEstimate> proposals;
  std::vector<Rectangle> seeds;
  for (const auto& config : configs) {
    detectors.push_back(detector_of(view, T_survey_robot, config));
    const RoomEstimate estimate = detectors.back().estimate(T_survey_robot).estimate;
    if (!estimate.found) continue;
    proposals.push_back(estimate);
    seeds.push_back(estimate.rectangle);
  }
  const OutlineLimits limits{configs.front().search.side_min_m, configs.front().search.side_max_m};
  const auto outline = choose_outline(seeds, look_around(view, T_survey_robot.translation()), limits);
  if (!outline) return {};
  const auto proposed = std::find(seeds.begin(), seeds.end(), *outline);
  if (proposed != seeds.end()) return proposals[static_cast<std::size_t>(proposed - seeds.begin())];
  const RoomEstimate described = detectors.back().describe(*outline).estimate;
  return described.found ? described : proposals.front();
}

}  // namespace

room_detector::RoomDetectorConfig planar(room_detector::RoomDetectorConfig config, double resolution_m) {
  const double from_m = planar_layer(resolution_m) * resolution_m;
  const double to_m = from_m + kPlanarLayers * resolution_m;
  config.band.band = room_detector::BandChoice::kUpper;
  config.band.wall_band_from_m = config.door_finder.band_from_m = from_m;
  config.band.wall_band_to_m = config.door_finder.band_to_m = to_m;
  config.door_finder.sill_m = to_m;
  config.beyond_floor_m = 0.0;
  return config;
}

FoundRoom find_room(const Survey& survey, const room_detector::RoomDetectorConfig& config,
                    const std::optional<Point2>& at) {
  const Pose2 T_survey_robot =
      at ? survey.T_file_survey.inverse() * Pose2{at->x(), at->y(), 0.0} : survey.T_survey_stand;
  Survey view = survey.is_fused ? seen_from(T_survey_robot.translation(), survey) : survey;
  if (survey.is_drawn()) view.hits = faces_seen(look_around(view, T_survey_robot.translation()));
  if (view.is_planar) thicken(view.cells);
  FoundRoom found{.T_file_robot = survey.T_file_survey * T_survey_robot, .points = standing_columns(survey)};
  const auto configs = suited_to(survey, config);
  found.estimate = view.is_planar
                       ? find_planar(view, T_survey_robot, configs)
                       : detector_of(view, T_survey_robot, configs.front()).estimate(T_survey_robot).estimate;
  if (found.estimate.found) found.estimate = moved(survey.T_file_survey, found.estimate);
  return found;
}

std::string to_svg(const FoundRoom& room, const std::string& title) {
  return draw::draw_scan({title, room.estimate, room.points, room.T_file_robot, kMargin_m, kPoint_px});
}

}  // namespace enfilade::room
