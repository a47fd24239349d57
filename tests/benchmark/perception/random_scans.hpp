// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "components/gridBuilder/core/zone_grid.hpp"
#include "components/roomDetector/core/wall_votes.hpp"
#include "tests/unit/components/roomDetector/sim_room.hpp"

namespace enfilade::bench {

/// A robot that turns about in a random furnished room and scans it into the real grid.
class RoomScans {
 public:
  explicit RoomScans(unsigned seed);

  static constexpr int kLines = 120;
  /// The next line: of sweep 0, then sweep 1 after a quarter turn, and so on.
  GridChange next_line();
  Pose2 T_zone_base() const;

 private:
  grid_builder::ScanLine scan(double roll_rad);

  room_detector::test::SimRoom room_;
  grid_builder::ZoneGrid grid_;
  std::mt19937 random_;
  int line_ = 0;
};

/// What the search is given: votes, and where the robot stands.
struct SearchInput {
  std::shared_ptr<const std::vector<room_detector::Vote>> votes;
  room_detector::Penalties penalties;
  Point2 origin = Point2::Zero();
  std::optional<Point2> robot;

  room_detector::HoughSpace space(const room_detector::HoughConfig& config) const;
};

/// The votes of `map`, those that say something.
SearchInput search_input(room_detector::ColumnMap& map, const room_detector::WallBand& band,
                         room_detector::Score score, const room_detector::HoughConfig& hough,
                         const Point2& robot);

/// 50 rooms after one, two, three and four sweeps, for either score at the default lattice.
struct SimulatedInputs {
  std::vector<SearchInput> evidence, paper;
};
const SimulatedInputs& simulated_inputs();

}  // namespace enfilade::bench
