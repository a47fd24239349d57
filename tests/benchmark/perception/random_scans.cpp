// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmark/perception/random_scans.hpp"

#include <cmath>

#include "tests/unit/components/roomDetector/random_rooms.hpp"

namespace enfilade::bench {
namespace {

constexpr int kRooms = 50;
constexpr int kSweeps = 4;
constexpr double kBeamStep_deg = 0.75;
constexpr double kSigma_m = 0.01;
constexpr double kMount_m[2] = {0.1, 0.6};

float single(double value) { return static_cast<float>(value); }

}  // namespace

using namespace room_detector;

RoomScans::RoomScans(unsigned seed) : room_(test::RandomRooms(seed).next()), grid_({}), random_(seed) {}

Pose2 RoomScans::T_zone_base() const {
  return room_.T_zone_room * Pose2{0.1, -0.1, 0.3 + 0.5 * kPi * (line_ / kLines)};
}

GridChange RoomScans::next_line() {
  const double roll = radians(-90.0 + 180.0 * (line_ % kLines) / (kLines - 1));
  auto update = grid_.insert(scan(roll));
  ++line_;
  return {.sequence = static_cast<std::uint64_t>(line_),
          .resolution_m = 0.05,
          .cells = std::move(update.changes)};
}

grid_builder::ScanLine RoomScans::scan(double roll_rad) {
  const Pose2 T_room_base = room_.T_zone_room.inverse() * T_zone_base();
  const Point2 in_room = T_room_base * Point2(kMount_m[0], 0.0),
               in_zone = T_zone_base() * Point2(kMount_m[0], 0.0);
  std::normal_distribution<double> noise_m(0.0, kSigma_m);
  grid_builder::ScanLine line{.stamp_ns = (line_ + 1) * 25'000'000,
                              .origin = {single(in_zone.x()), single(in_zone.y()), single(kMount_m[1])}};
  for (double beam = -135.0; beam <= 135.0; beam += kBeamStep_deg) {
    const double a = radians(beam), across = std::sin(a) * std::cos(roll_rad),
                 up = std::sin(a) * std::sin(roll_rad);
    const Point2 flat = rotate(T_room_base.yaw_rad, {std::cos(a), across}),
                 way = rotate(T_zone_base().yaw_rad, {std::cos(a), across});
    const double range =
        test::cast(room_.boxes, {in_room.x(), in_room.y(), kMount_m[1]}, {flat.x(), flat.y(), up});
    const bool is_hit = range < 30.0;
    const double length = is_hit ? range + noise_m(random_) : 8.0;
    (is_hit ? line.hits : line.free_ends)
        .push_back({single(in_zone.x() + length * way.x()), single(in_zone.y() + length * way.y()),
                    single(kMount_m[1] + length * up)});
  }
  return line;
}

HoughSpace SearchInput::space(const HoughConfig& config) const {
  HoughSpace space(config, origin, 0.05);
  for (std::size_t i = 0; i < votes->size(); ++i) space.set(i, (*votes)[i]);
  space.set_penalties(penalties);
  return space;
}

SearchInput search_input(ColumnMap& map, const WallBand& band, Score score, const HoughConfig& hough,
                         const Point2& robot) {
  WallVotes votes({.score = score}, hough);
  const Point2 origin(std::round(robot.x()), std::round(robot.y()));
  const HoughSpace& space = votes.update(map, band, origin, robot);
  std::vector<Vote> telling;
  for (const Vote& vote : space.votes()) {
    if (vote.occupied + vote.free + vote.interior > 0) telling.push_back(vote);
  }
  return {std::make_shared<std::vector<Vote>>(std::move(telling)), space.penalties(), origin, robot};
}

const SimulatedInputs& simulated_inputs() {
  static const SimulatedInputs all = [] {
    SimulatedInputs inputs;
    for (unsigned seed = 0; seed < kRooms; ++seed) {
      RoomScans scans(seed);
      ColumnMap map;
      map.clear(0.05);
      for (int sweep = 0; sweep < kSweeps; ++sweep) {
        const Point2 robot = scans.T_zone_base().translation();
        for (int line = 0; line < RoomScans::kLines; ++line) map.apply(scans.next_line().cells);
        const auto upper = choose_wall_band(map, {}), all_heights = choose_wall_band(map, {BandChoice::kAll});
        inputs.evidence.push_back(search_input(map, upper, Score::kEvidence, {}, robot));
        inputs.paper.push_back(search_input(map, all_heights, Score::kPaper, {}, robot));
      }
    }
    return inputs;
  }();
  return all;
}

}  // namespace enfilade::bench
