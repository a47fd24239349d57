// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include <Eigen/Core>

#include "components/explorer/core/projected_grid.hpp"
#include "interfaces/model/room.hpp"

namespace enfilade::explorer {

struct ViewTargetsConfig {
  double along_step_m = 0.10;  ///< between samples of a wall
  double height_step_m = 0.25;
  double band_from_m = 0.15;  ///< the heights in which a door is told from a wall
  double band_to_m = 1.90;
  double gap_weight = 3.0;  ///< a square metre of a wall that may hold a door, against one of plain wall
  double narrowest_gap_m = 0.5;
  double floor_step_m = 0.25;
  double floor_weight = 0.2;  ///< a square metre of unexplored floor inside the room
  double futility = 0.35;     ///< what could have been seen and was not counts this much less each time
};

/// Something unexplored that is worth seeing.
struct ViewTarget {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< zone frame
  double worth_m2 = 0.0;
  std::uint64_t key = 0;  ///< the cell
};

/// Finds what is unexplored inside an estimated room: in the planes of its walls, above all where a door may
/// be, and on its floor. Remembers what was looked at in vain.
class ViewTargets {
 public:
  explicit ViewTargets(const ViewTargetsConfig& config);

  void reset() { vain_.clear(); }
  std::vector<ViewTarget> find(const ProjectedGrid& grid, const RoomEstimate& estimate) const;
  /// Targets inside any rectangle, for when no room is known: only the floor counts.
  std::vector<ViewTarget> find_floor(const ProjectedGrid& grid, const Rectangle& area) const;
  /// `target` should have been seen from where the last sweep was made.
  void looked_in_vain(const ViewTarget& target) { ++vain_[target.key]; }

 private:
  void add_wall(const ProjectedGrid& grid, const RoomEstimate& estimate, int wall,
                std::vector<ViewTarget>& targets) const;
  void add_floor(const ProjectedGrid& grid, const Rectangle& area, std::vector<ViewTarget>& targets) const;
  ViewTarget target(const ProjectedGrid& grid, const Eigen::Vector3d& at, double worth_m2) const;

  ViewTargetsConfig config_;
  std::map<std::uint64_t, int> vain_;
};

}  // namespace enfilade::explorer
