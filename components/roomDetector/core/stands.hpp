// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "components/roomDetector/core/hit_map.hpp"

namespace enfilade::room_detector {

struct StandsConfig {
  double move_m = 0.005;      ///< the robot has moved if it went so far …
  double turn_deg = 0.3;      ///< … or turned so much: another stand begins
  int most = 12;              ///< stands kept apart; of more, the oldest are put together
  double jamb_from_m = 0.15;  ///< returns between these heights tell where a door ends
  double jamb_to_m = 1.9;
  double sensor_forward_m = 0.10;  ///< of the laser from base_link, and
  double sensor_height_m = 0.60;   ///< over the floor: whence a return was measured
};

/// Where the robot stood for a while, and what it measured from there.
struct Stand {
  Pose2 T_zone_base;
  HitMap hits;               ///< by cell of the grid
  HitMap fine_hits;          ///< by upright column of 1 cm, at the heights of doors
  std::uint32_t merged = 0;  ///< older stands that were put into this one
  /// The returns at the heights of the band followed, by upright column, where odometry had them.
  std::vector<WallPoint> wall_points;
};

/// The returns of the laser in one zone, by stand: what was measured from one place is rigid, whatever
/// odometry did in between.
class Stands {
 public:
  explicit Stands(const StandsConfig& config) : config_(config) {}

  void clear() {
    stands_.clear();
    followed_ = 0;
  }
  void add(const ScanHits& line, double resolution_m);

  bool empty() const { return stands_.empty(); }
  const std::vector<Stand>& all() const { return stands_; }
  /// Brings the wall points of all stands up to date with this band.
  void follow(const WallBand& band);

 private:
  bool is_new_stand(const Pose2& T_zone_base) const;
  void put_oldest_together();
  std::vector<WallPoint> wall_points(const Stand& stand) const;

  StandsConfig config_;
  std::vector<Stand> stands_;
  WallBand band_;
  std::size_t followed_ = 0;  // stands before this one have not changed since the band was followed
};

}  // namespace enfilade::room_detector
