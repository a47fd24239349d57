// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "components/gridBuilder/core/zone_grid.hpp"
#include "components/laser3D/core/replay_cloud.hpp"
#include "components/laser3D/core/text_lines.hpp"

namespace enfilade::room {

/// Height over the floor at which level range finders and floor plans are taken to lie.
inline constexpr double kPlanarHeight_m = 0.6;

struct SurveyConfig {
  laser_3d::ReplayCloudConfig cloud;
  grid_builder::ZoneGridConfig grid;
  double map_resolution_m = 0.05;  ///< side of a pixel where an image comes without a map_server YAML
};

/// What a file tells of a building: one grid, floor at z = 0, as gridBuilder would have built it.
struct Survey {
  double resolution_m = 0.05;
  std::vector<GridCell> cells;  ///< the known ones
  std::vector<CellHit> hits;    ///< returns behind them; none where only the grid is known
  bool is_fused = false;        ///< from many places, not from T_survey_stand alone
  bool is_planar = false;       ///< one layer, at kPlanarHeight_m: nothing is known of heights
  /// A map: its walls begin where free floor ends, however thick they are.
  bool is_drawn() const { return is_planar && hits.empty(); }
  Pose2 T_survey_stand;  ///< where the robot stands unless the user says otherwise
  Pose2 T_file_survey;   ///< the coordinates of the file, which its user knows
};

/// Layer of cells that holds kPlanarHeight_m.
int planar_layer(double resolution_m);

/// By the ending of the name: .bt, .pcd, .3d, .clf, .log, .yaml, .png, .pgm. Throws std::runtime_error with
/// one sentence that names the file and what to do.
Survey read_survey(const std::string& file, const SurveyConfig& config);

// One for each kind of file.
Survey survey_of_cloud(const laser_3d::FileBytes& file, const SurveyConfig& config);
Survey survey_of_log(const laser_3d::FileBytes& file, const SurveyConfig& config);
Survey survey_of_octree(const laser_3d::FileBytes& file);
Survey survey_of_map(const std::string& file, const SurveyConfig& config);

/// Centre of the largest free square of columns: the middle of the roomiest place.
Pose2 roomiest_place(const Survey& survey);

}  // namespace enfilade::room
