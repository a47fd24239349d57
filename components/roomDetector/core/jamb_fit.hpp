// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "components/roomDetector/core/hit_map.hpp"
#include "interfaces/model/room.hpp"

namespace enfilade::room_detector {

struct JambFitConfig {
  double reach_m = 0.2;          ///< a jamb may lie so far from the edge of the cells, either way
  double face_m = 0.035;         ///< returns so near to the wall plane lie on the face of the wall
  double reveal_from_m = 0.04;   ///< returns so far behind the plane …
  double reveal_to_m = 0.4;      ///< … to so far may lie on the jamb itself
  double reveal_width_m = 0.03;  ///< a jamb's returns spread no wider than this along the wall
  double min_reveal_m = 0.04;    ///< the depth over which they are seen, at least
  double min_weight = 12.0;      ///< returns that tell where a jamb is, at least
};

/// A return as a wall sees it.
struct HitByWall {
  double along_m = 0.0;    ///< from the wall's first corner
  double outside_m = 0.0;  ///< behind the wall plane
  double weight = 1.0;
};

/// Those of the returns that may lie on the wall beside a gap of it, or on a jamb.
std::vector<HitByWall> hits_beside(std::span<const PlacedHits> hits, const Rectangle& rectangle,
                                   const WallInterval& gap, const JambFitConfig& config);

/// A gap whose ends were fitted, and how well they are known (standard deviations).
struct FittedGap {
  WallInterval gap;
  double from_sigma_m = 0.0, to_sigma_m = 0.0;

  double width_sigma_m() const;
};

/// The interval with both ends moved from the edges of cells of `cell_m` to the jambs: to the returns from
/// the jamb itself where it was seen, else to where the face of the wall ends. An end that no returns tell
/// stays.
FittedGap fit_jambs(std::span<const HitByWall> hits, const WallInterval& gap, const JambFitConfig& config,
                    double cell_m = 0.05);

}  // namespace enfilade::room_detector
