// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/door_finder.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "components/roomDetector/core/convex_region.hpp"
#include "components/roomDetector/core/gap_runs.hpp"
#include "components/roomDetector/core/wall_profile.hpp"

namespace enfilade::room_detector {
namespace {

constexpr double kBridge_m = 0.1;  // stray cells in a door
constexpr double kHighestLintel_m = 3.0;
// A cell of an opening is found free in 95 of 100 cases and occupied in 5, one of a wall the other way round:
// ln(0.95 / 0.05) for a slice seen whole.
const double kNatsPerSlice = std::log(0.95 / 0.05);

/// One wall under examination.
struct Wall {
  const ColumnMap& map;
  const Rectangle& rectangle;
  int index;
  std::vector<WallSlice> slices;
  Levels band;
  std::span<const PlacedHits> returns;
  std::span<const Sightings> sightings;
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
  ConvexRegion wedge;
  wedge.cut(segment.from + config.beyond_from_m * outwards, outwards)
      .cut(segment.from + config.beyond_to_m * outwards, -outwards)
      .cut(segment.from + gap.from_m * along, (along + outwards).normalized())
      .cut(segment.from + gap.to_m * along, (outwards - along).normalized());
  wall.map.visit_within(wedge, [&](const ColumnMap::Counts& counts) {
    evidence.beyond_occupied_cells += counts.occupied;
    evidence.beyond_free_cells += counts.free;
  });
}

/// What is seen from a point through a gap and lies at least `depth_m` behind it.
ConvexRegion seen_through(const Segment& line, const Point2& outwards, const WallInterval& gap,
                          const Point2& from, double depth_m) {
  const Point2 along = line.direction();
  const Point2 to_first = line.from + gap.from_m * along - from,
               to_last = line.from + gap.to_m * along - from;
  const auto across = [&](const Point2& ray) { return Point2(-ray.y(), ray.x()).normalized(); };
  const double side = along.dot(across(to_first)) > 0.0 ? 1.0 : -1.0;
  ConvexRegion region;
  region.cut(line.from + depth_m * outwards, outwards)
      .cut(from, side * across(to_first))
      .cut(from, -side * across(to_last));
  return region;
}

/// Whether enough returns came from behind the wall whose beams went through the gap.
bool is_seen_through(const Wall& wall, const WallInterval& gap, const DoorFinderConfig& config) {
  const Segment line = wall.rectangle.wall(wall.index);
  const Point2 outwards = wall.rectangle.normal(wall.index);
  double returns = 0.0;
  for (const Sightings& s : wall.sightings) {
    if ((s.from - line.from).dot(outwards) >= 0.0) continue;  // the robot is not before this wall
    const auto behind = seen_through(line, outwards, gap, s.from, config.beyond_from_m);
    s.returns.hits->visit_within(behind, s.returns.T_map_hits, [&](const Point2&, double count) {
      returns += count;
      return returns < config.min_returns_behind;
    });
  }
  return returns >= config.min_returns_behind;
}

Levels foot_of(const Wall& wall, const DoorFinderConfig& config) {
  const double r = wall.map.resolution_m();
  return level_range(level_of(config.band_from_m, r), level_of(config.sill_m, r));
}

/// What the wall plane says of a stretch, before it is judged.
GapDiagnostics look_at(const Wall& wall, const Run& run, const DoorFinderConfig& config) {
  const double r = wall.map.resolution_m(), length = wall.rectangle.wall_length_m(wall.index);
  GapDiagnostics seen;
  seen.gap = {static_cast<std::uint8_t>(wall.index), static_cast<double>(run.from) * r,
              std::min(length, static_cast<double>(run.to) * r)};
  const SliceShares share = shares_of(wall.slices, run.from, run.to, wall.band);
  seen.occupied_share = share.occupied;
  seen.free_share = share.free;
  seen.foot_free_share = shares_of(wall.slices, run.from, run.to, foot_of(wall, config)).free;
  // The cells of a slice are looked at by the same few beams: a slice counts once.
  seen.open_nats = kNatsPerSlice * static_cast<double>(run.size()) * (share.free - share.occupied);
  return seen;
}

struct Judgement {
  GapVerdict verdict;
  const char* reason;
};

/// An opening that was seen free is a door if it reaches down to the floor, something was seen behind it, and
/// it is not as wide as a missing wall.
Judgement judge_open(const Wall& wall, const GapDiagnostics& seen, const DoorFinderConfig& config) {
  if (seen.gap.width_m() > config.max_width_m)
    return {GapVerdict::kPossible, "wider than a door: a wall may be missing"};
  if (seen.foot_free_share < 0.5 * config.min_free_share)
    return {GapVerdict::kPossible, "open, but its foot was not seen: there may be a sill"};
  if (!wall.sightings.empty() && !is_seen_through(wall, seen.gap, config))
    return {GapVerdict::kPossible, "nothing was seen through it: glass, or nothing in reach"};
  return {GapVerdict::kOpen, "free from the floor to the lintel"};
}

/// What is left of a gap: unexplored, or possibly a door where part of it was seen free and nothing stands in
/// it.
std::optional<Judgement> judge_rest(const GapDiagnostics& seen, const DoorFinderConfig& config) {
  const double width = seen.gap.width_m(), unknown = 1.0 - seen.occupied_share - seen.free_share;
  if (width < config.min_unexplored_m) return std::nullopt;
  const Judgement unexplored{GapVerdict::kUnexplored, "not seen: no door, a place to look at"};
  if (seen.free_share < 0.5 * config.min_free_share) return unexplored;
  if (width >= config.min_width_m && width <= config.max_width_m)
    return Judgement{GapVerdict::kPossible, "nothing stands in it, but too little of it was seen"};
  return unknown > 0.5 ? std::optional(unexplored) : std::nullopt;
}

void report(const Wall& wall, const Run& run, GapDiagnostics seen, const Judgement& judgement,
            const DoorFinderConfig& config, WallGaps& gaps) {
  seen.verdict = judgement.verdict;
  seen.reason = judgement.reason;
  DoorEstimate door;
  door.state = static_cast<DoorState>(judgement.verdict);
  door.gap = seen.gap;
  door.evidence.occupied_share = seen.occupied_share;
  door.evidence.free_share = seen.free_share;
  if (door.state != DoorState::kUnexplored) {
    const FittedGap fitted = fit_jambs(hits_beside(wall.returns, wall.rectangle, seen.gap, config.jamb),
                                       seen.gap, config.jamb, wall.map.resolution_m());
    door.gap = seen.gap = fitted.gap;
    seen.from_sigma_m = fitted.from_sigma_m;
    seen.to_sigma_m = fitted.to_sigma_m;
    door.width_sigma_m = fitted.width_sigma_m();
    door.position_sigma_m = 0.5 * door.width_sigma_m;
    door.height_m = lintel_m(wall, run, config);
    if (door.height_m) door.height_sigma_m = wall.map.resolution_m() / std::sqrt(12.0);
    count_beyond(wall, door.gap, config, door.evidence);
  }
  gaps.doors.push_back(door);
  gaps.diagnostics.push_back(seen);
}

/// Stretches that are free above something that stands in them: windows, hatches, furniture before a door.
void report_windows(const Wall& wall, const std::vector<SliceKind>& kinds, const DoorFinderConfig& config,
                    WallGaps& gaps) {
  const auto is_window = [&](std::size_t i) {
    return kinds[i] == SliceKind::kWall &&
           shares_of(wall.slices, i, i + 1, wall.band).free >= 0.5 * config.min_free_share;
  };
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    Run run{i, i};
    while (run.to < kinds.size() && is_window(run.to)) ++run.to;
    if (static_cast<double>(run.size()) * wall.map.resolution_m() < config.min_width_m) continue;
    GapDiagnostics seen = look_at(wall, run, config);
    seen.reason = seen.foot_free_share < 0.5 * config.min_free_share
                      ? "a sill stands in it: a window or a hatch"
                      : "something stands in it";
    gaps.diagnostics.push_back(seen);
    i = run.to;
  }
}

void find_in(const Wall& wall, const DoorFinderConfig& config, WallGaps& gaps) {
  const double r = wall.map.resolution_m();
  const GapLengths lengths{slices_of(config.min_width_m, r), slices_of(kBridge_m, r),
                           slices_of(config.min_unexplored_m, r)};
  const auto kinds = kinds_of(wall, config);
  const auto first = static_cast<std::ptrdiff_t>(gaps.doors.size());
  for (const Gap& gap : find_gaps(kinds, lengths)) {
    for (const Run& run : gap.open) {
      const GapDiagnostics seen = look_at(wall, run, config);
      report(wall, run, seen, judge_open(wall, seen, config), config, gaps);
    }
    for (const Run& run : gap.rest) {
      const GapDiagnostics seen = look_at(wall, run, config);
      if (const auto judgement = judge_rest(seen, config)) report(wall, run, seen, *judgement, config, gaps);
    }
  }
  report_windows(wall, kinds, config, gaps);
  std::stable_sort(gaps.doors.begin() + first, gaps.doors.end(),
                   [](const DoorEstimate& a, const DoorEstimate& b) { return a.gap.from_m < b.gap.from_m; });
}

}  // namespace

DoorFinder::DoorFinder(const DoorFinderConfig& config) : config_(config) {}

WallGaps DoorFinder::find(const ColumnMap& map, const Rectangle& rectangle, std::span<const PlacedHits> hits,
                          std::span<const Sightings> sightings) const {
  const Levels band = level_range(level_of(config_.band_from_m, map.resolution_m()),
                                  level_of(config_.band_to_m, map.resolution_m()));
  WallGaps gaps;
  double unexplored = 0.0, slices = 0.0;
  for (int i = 0; i < 4; ++i) {
    const Wall wall{map, rectangle, i, profile_wall(map, rectangle, i), band, hits, sightings};
    find_in(wall, config_, gaps);
    const auto size = static_cast<double>(wall.slices.size());
    unexplored += size * shares_of(wall.slices, 0, wall.slices.size(), band).unknown();
    slices += size;
  }
  if (slices > 0.0) gaps.unexplored_share = unexplored / slices;
  return gaps;
}

}  // namespace enfilade::room_detector
