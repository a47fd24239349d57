// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/door_finder.hpp"

#include <algorithm>
#include <cmath>

#include "components/roomDetector/core/gap_runs.hpp"
#include "components/roomDetector/core/wall_profile.hpp"

namespace enfilade::room_detector {
namespace {

constexpr double kBridge_m = 0.1;  // stray cells in a door
constexpr double kHighestLintel_m = 3.0;

/// One wall under examination.
struct Wall {
  const ColumnMap& map;
  const Rectangle& rectangle;
  int index;
  std::vector<WallSlice> slices;
  Levels band;
  std::vector<HitByWall> hits;
};

std::size_t slices_of(double metres, double resolution_m) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(metres / resolution_m - 1e-6)));
}

std::vector<SliceKind> kinds_of(const Wall& wall, const DoorFinderConfig& config) {
  std::vector<SliceKind> kinds;
  for (std::size_t i = 0; i < wall.slices.size(); ++i) {
    const SliceShares share = shares_of(wall.slices, i, i + 1, wall.band);
    kinds.push_back(share.occupied > config.max_occupied_share ? SliceKind::kWall
                    : share.free >= config.min_free_share      ? SliceKind::kFree
                                                               : SliceKind::kUnknown);
  }
  return kinds;
}

/// Underside of what hangs over the gap: the median of the lowest occupied levels above the band, if half the
/// slices have one.
std::optional<double> lintel_m(const Wall& wall, const Run& run, const DoorFinderConfig& config) {
  const double r = wall.map.resolution_m();
  std::vector<int> lowest;
  for (std::size_t i = run.from; i < run.to; ++i) {
    for (int l = level_of(config.band_to_m, r); l < level_of(kHighestLintel_m, r); ++l) {
      if (!wall.slices[i].occupied[static_cast<std::size_t>(l)]) continue;
      lowest.push_back(l);
      break;
    }
  }
  if (2 * lowest.size() < run.size() || lowest.empty()) return std::nullopt;
  std::nth_element(lowest.begin(), lowest.begin() + static_cast<std::ptrdiff_t>(lowest.size() / 2),
                   lowest.end());
  return bottom_of(lowest[lowest.size() / 2], r);
}

/// Counts what was seen behind the wall through the gap: in a wedge that widens by 45° on either side.
void count_beyond(const Wall& wall, const WallInterval& gap, const DoorFinderConfig& config,
                  DoorEvidence& evidence) {
  const Segment segment = wall.rectangle.wall(wall.index);
  const Point2 along = segment.direction(), outwards = wall.rectangle.normal(wall.index);
  const Levels heights = level_range(level_of(config.beyond_floor_m, wall.map.resolution_m()), kLevels);
  for (const Column& column : wall.map.columns()) {
    const Point2 q = wall.map.centre(column) - segment.from;
    const double depth = q.dot(outwards), s = q.dot(along);
    if (depth < config.beyond_from_m || depth > config.beyond_to_m) continue;
    if (s < gap.from_m - depth || s > gap.to_m + depth) continue;
    evidence.beyond_occupied_cells += static_cast<std::uint32_t>((column.occupied & heights).count());
    evidence.beyond_free_cells += static_cast<std::uint32_t>((column.free & heights).count());
  }
}

DoorEstimate describe(const Wall& wall, const Run& run, DoorState state, const DoorFinderConfig& config) {
  const double r = wall.map.resolution_m(), length = wall.rectangle.wall_length_m(wall.index);
  DoorEstimate door;
  door.gap = {static_cast<std::uint8_t>(wall.index), static_cast<double>(run.from) * r,
              std::min(length, static_cast<double>(run.to) * r)};
  door.state = state;
  const SliceShares share = shares_of(wall.slices, run.from, run.to, wall.band);
  door.evidence.occupied_share = share.occupied;
  door.evidence.free_share = share.free;
  if (state == DoorState::kUnexplored) return door;
  door.gap = fit_jambs(wall.hits, door.gap, config.jamb);
  door.height_m = lintel_m(wall, run, config);
  count_beyond(wall, door.gap, config, door.evidence);
  return door;
}

/// An opening that was seen free is a door if it reaches down to the floor and is not as wide as a missing
/// wall.
DoorState state_of_open(const Wall& wall, const Run& run, const DoorFinderConfig& config) {
  const double r = wall.map.resolution_m();
  const Levels foot = level_range(level_of(config.band_from_m, r), level_of(config.sill_m, r));
  const bool reaches_down =
      shares_of(wall.slices, run.from, run.to, foot).free >= 0.5 * config.min_free_share;
  const bool is_wall_missing = static_cast<double>(run.size()) * r > config.max_width_m;
  return reaches_down && !is_wall_missing ? DoorState::kOpen : DoorState::kPossible;
}

/// What is left of a gap: unexplored, or possibly a door where part of it was seen free and nothing stands in
/// it.
std::optional<DoorState> state_of_rest(const Wall& wall, const Run& run, const DoorFinderConfig& config) {
  const double width = static_cast<double>(run.size()) * wall.map.resolution_m();
  if (width < config.min_unexplored_m) return std::nullopt;
  const SliceShares share = shares_of(wall.slices, run.from, run.to, wall.band);
  if (share.free < 0.5 * config.min_free_share) return DoorState::kUnexplored;
  if (width >= config.min_width_m && width <= config.max_width_m) return DoorState::kPossible;
  return share.unknown() > 0.5 ? std::optional(DoorState::kUnexplored) : std::nullopt;
}

std::vector<DoorEstimate> doors_in(const Wall& wall, const DoorFinderConfig& config) {
  const double r = wall.map.resolution_m();
  const GapLengths lengths{slices_of(config.min_width_m, r), slices_of(kBridge_m, r),
                           slices_of(config.min_unexplored_m, r)};
  std::vector<DoorEstimate> doors;
  for (const Gap& gap : find_gaps(kinds_of(wall, config), lengths)) {
    for (const Run& run : gap.open)
      doors.push_back(describe(wall, run, state_of_open(wall, run, config), config));
    for (const Run& run : gap.rest) {
      if (const auto state = state_of_rest(wall, run, config))
        doors.push_back(describe(wall, run, *state, config));
    }
  }
  std::stable_sort(doors.begin(), doors.end(),
                   [](const DoorEstimate& a, const DoorEstimate& b) { return a.gap.from_m < b.gap.from_m; });
  return doors;
}

}  // namespace

DoorFinder::DoorFinder(const DoorFinderConfig& config) : config_(config) {}

WallGaps DoorFinder::find(const ColumnMap& map, const Rectangle& rectangle,
                          std::span<const WallPoint> hits) const {
  const Levels band = level_range(level_of(config_.band_from_m, map.resolution_m()),
                                  level_of(config_.band_to_m, map.resolution_m()));
  WallGaps gaps;
  double unexplored = 0.0, slices = 0.0;
  for (int i = 0; i < 4; ++i) {
    const Wall wall{map,  rectangle,
                    i,    profile_wall(map, rectangle, i),
                    band, hits_by_wall(hits, rectangle, i, config_.jamb)};
    const auto doors = doors_in(wall, config_);
    gaps.doors.insert(gaps.doors.end(), doors.begin(), doors.end());
    const auto size = static_cast<double>(wall.slices.size());
    unexplored += size * shares_of(wall.slices, 0, wall.slices.size(), band).unknown();
    slices += size;
  }
  if (slices > 0.0) gaps.unexplored_share = unexplored / slices;
  return gaps;
}

}  // namespace enfilade::room_detector
