// SPDX-License-Identifier: Apache-2.0
#include "tools/room/survey.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "components/laser3D/core/carmen_reader.hpp"
#include "components/laser3D/core/point_file.hpp"
#include "interfaces/runtime/read_file.hpp"
#include "tools/support/files.hpp"

namespace enfilade::room {
namespace {

constexpr std::uintmax_t kMostBytes = 1'000'000'000;

laser_3d::FileBytes bytes_of(const std::string& name) {
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(name, unknown);
  if (!unknown && size > kMostBytes)
    throw std::runtime_error(name + ": is larger than 1 GB: give a part of it");
  return {name, read_file(name)};
}

void insert(grid_builder::ZoneGrid& grid, const grid_builder::ScanLine& line, Survey& survey) {
  const grid_builder::LineUpdate update = grid.insert(line);
  survey.hits.insert(survey.hits.end(), update.hits.begin(), update.hits.end());
}

}  // namespace

int planar_layer(double resolution_m) {
  return static_cast<int>(std::floor(kPlanarHeight_m / resolution_m + 1e-6));
}

Survey read_survey(const std::string& file, const SurveyConfig& config) {
  const std::string ending = ending_of(file);
  if (ending == ".yaml" || ending == ".png" || ending == ".pgm") return survey_of_map(file, config);
  if (ending == ".bt") return survey_of_octree(bytes_of(file));
  if (ending == ".pcd" || ending == ".3d") return survey_of_cloud(bytes_of(file), config);
  if (ending == ".clf" || ending == ".log") return survey_of_log(bytes_of(file), config);
  throw std::runtime_error((file.empty() ? "\"\"" : file) +
                           ": what it holds is told by its ending, which must be .bt, .pcd, .3d, .clf, "
                           ".log, .yaml, .png or .pgm");
}

Survey survey_of_cloud(const laser_3d::FileBytes& file, const SurveyConfig& config) {
  const laser_3d::ScannedPoints scanned = laser_3d::read_points(file);
  const auto cloud = laser_3d::make_replay_cloud(config.cloud, scanned);
  if (!cloud) laser_3d::reject(file, "no floor lies below the scanner: turn the cloud so that z points up");
  Survey survey{.resolution_m = config.grid.resolution_m,
                .T_file_survey = {scanned.origin.x_m, scanned.origin.y_m, 0.0}};
  grid_builder::ZoneGrid grid(config.grid);
  grid_builder::ScanLine line{.origin = {0.0F, 0.0F, static_cast<float>(cloud->scanner_height_m)}};
  for (std::size_t i = 0; i < cloud->lines.size(); ++i) {
    ++line.stamp_ns;
    line.hits = cloud->lines[i];
    line.free_ends = cloud->free_ends[i];
    insert(grid, line, survey);
  }
  survey.cells = grid.known_cells();
  return survey;
}

Survey survey_of_log(const laser_3d::FileBytes& file, const SurveyConfig& config) {
  const laser_3d::CarmenLog log = laser_3d::read_carmen(file);
  grid_builder::ZoneGridConfig one_layer = config.grid;
  const double r = one_layer.resolution_m;
  const int layer = planar_layer(r);
  one_layer.min_height_m = layer * r;
  one_layer.max_height_m = (layer + 1) * r;
  grid_builder::ZoneGrid grid(one_layer);
  Survey survey{
      .resolution_m = r, .is_fused = true, .is_planar = true, .T_survey_stand = log.scans.back().T_map_laser};
  const auto at_layer = [z = static_cast<float>((layer + 0.5) * r)](const Point2& p) {
    return Point3f{static_cast<float>(p.x()), static_cast<float>(p.y()), z};
  };
  StampNs stamp_ns = 0;
  for (const laser_3d::CarmenScan& scan : log.scans) {
    grid_builder::ScanLine line{++stamp_ns, at_layer(scan.T_map_laser.translation()), {}, {}};
    for (const Point2& p : laser_3d::returns_of(scan, one_layer.max_range_m))
      line.hits.push_back(at_layer(p));
    insert(grid, line, survey);
  }
  survey.cells = grid.known_cells();
  return survey;
}

Pose2 roomiest_place(const Survey& survey) {
  // Lowest and highest heights that say whether a robot could stand there.
  const auto from = static_cast<int>(std::ceil(0.15 / survey.resolution_m)),
             to = static_cast<int>(std::ceil(1.5 / survey.resolution_m));
  std::map<std::pair<int, int>, int> side;  // of the largest free square with this upper right corner
  for (const GridCell& c : survey.cells) {
    if (c.z < from || c.z >= to) continue;
    int& column = side.try_emplace({c.x, c.y}, 1).first->second;
    if (c.state != CellState::kFree) column = 0;
  }
  const auto side_at = [&side](int x, int y) {
    const auto it = side.find({x, y});
    return it == side.end() ? 0 : it->second;
  };
  Pose2 best;
  int widest = 0;
  for (auto& [at, squares] : side) {
    const auto [x, y] = at;
    if (squares > 0) squares += std::min({side_at(x - 1, y), side_at(x, y - 1), side_at(x - 1, y - 1)});
    if (squares <= widest) continue;
    widest = squares;
    const double back = 0.5 * squares;
    best = {(x + 1 - back) * survey.resolution_m, (y + 1 - back) * survey.resolution_m, 0.0};
  }
  return best;
}

}  // namespace enfilade::room
