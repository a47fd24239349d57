// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "components/roomDetector/core/door_finder.hpp"
#include "components/roomDetector/core/explain.hpp"
#include "components/roomDetector/core/joint_fit.hpp"
#include "components/roomDetector/core/paper_doors.hpp"
#include "components/roomDetector/core/rectangle_fit.hpp"
#include "components/roomDetector/core/rectangle_search.hpp"
#include "components/roomDetector/core/stands.hpp"
#include "components/roomDetector/core/wall_band.hpp"
#include "components/roomDetector/core/wall_votes.hpp"
#include "interfaces/model/room.hpp"

namespace enfilade::room_detector {

enum class DoorMethod { kPaper, kEvidence };

struct RoomDetectorConfig {
  HoughConfig hough;
  WallBandConfig band;
  WallVotesConfig votes;
  SearchConfig search;
  bool refine =
      true;  ///< fit the walls to the returns of the laser, beyond the resolution of the Hough space
  RectangleFitConfig fit;
  JointFitConfig joint;
  DoorMethod doors = DoorMethod::kEvidence;
  DoorFinderConfig door_finder;
  double beyond_floor_m = kCountedFrom_m;  ///< what lies behind a door counts from this height on
  PaperDoorsConfig paper_doors;
  StandsConfig stands;
};

/// What a person would want to know of one estimate.
struct DetectionDiagnostics {
  bool above_furniture = false;  ///< the walls were looked for above furniture
  SearchResult search;
  Rectangle coarse;  ///< eq. 10–13, before the refinement
  std::optional<RectangleFit> fit;
  std::vector<GapDiagnostics> gaps;  ///< of door_finder
  std::vector<Pose2> corrections;    ///< T_zone_odom of each stand of the robot, where they were estimated
  std::optional<RectangleFit> recent_fit;
};

struct Detection {
  RoomEstimate estimate;
  DetectionDiagnostics diagnostics;
};

/// Section III: the room and its doors from the occupancy grid, kept up to date with the changes of the grid.
class RoomDetector {
 public:
  /// `runner` works off what the search of a rectangle does beside each other.
  explicit RoomDetector(const RoomDetectorConfig& config, TaskRunner runner = {});

  /// Forgets everything: a new grid begins.
  void clear(double resolution_m);
  void update(const GridChange& change);
  /// A grid that has grown before: of its cells nobody tells the returns.
  void adopt(const GridChange& snapshot);
  void add_hits(const ScanHits& hits);
  /// The room model of this moment. `robot` is where the robot stands in the zone frame, if that is known.
  /// The caller fills in tag, sequence and stamps.
  Detection estimate(const std::optional<Pose2>& T_zone_base);
  /// The room model with `outline` in place of the argmax of the last estimate; nothing found where the Hough
  /// space does not hold it.
  Detection describe(const Rectangle& outline);
  /// Why the last estimate is what it is. The caller fills in tag, sequence and stamp.
  RoomDiagnostics explain(const Detection& d) const;

 private:
  void complete(Detection& d, const HoughSpace& space) const;
  void refine(Detection& d, const WallBand& band) const;
  void find_doors(Detection& d, const HoughSpace& space) const;
  void fit_recent(Detection& d) const;
  /// Returns, and centres of the cells far from any: those of a snapshot taken after a restart.
  bool is_closed(const SearchResult& best) const;
  std::vector<std::size_t> stands_in(const Rectangle& room) const;
  std::vector<WallPoint> cells_far_from(const std::vector<StandPoints>& stands, const WallBand& band) const;
  std::vector<PlacedHits> jamb_hits(const Detection& d) const;
  std::vector<Sightings> sightings(const Detection& d) const;

  RoomDetectorConfig config_;
  ColumnMap map_;
  WallBand band_;  ///< of the last estimate
  WallVotes votes_;
  RectangleSearch search_;
  RectangleFitter fitter_;
  DoorFinder door_finder_;
  JointFitter joint_fitter_;
  Stands stands_;
  bool returns_missed_ = false;  ///< some of this grid's were never told
};

}  // namespace enfilade::room_detector
