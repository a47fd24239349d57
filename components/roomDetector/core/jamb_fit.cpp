// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/jamb_fit.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace enfilade::room_detector {
namespace {

constexpr double kStrayShare = 0.02;      // of the returns of a face that lie beyond its end by noise
constexpr double kHidden_m = 0.075;       // a face that ends so far before the gap is hidden, not at its end
constexpr double kFineCell_m = 0.01;      // the returns are summed up by columns of this side
constexpr double kSameBeam_m = 0.004;     // returns so close together say nothing of the spacing of beams
constexpr double kSpacingReach_m = 0.25;  // of the end, where the spacing of beams is looked at
constexpr double kSteady_m = 0.001;       // no edge of a building is straighter
constexpr double kFrame_m = 0.02;         // a face that reaches so far past the reveal is a door frame

/// One end of a gap. Positions are counted into the gap, from the edge of the cells.
struct End {
  double at_m;
  double into_gap;  // +1 or -1, along the wall
};

struct Sample {
  double into_m, outside_m, weight;
};

/// Returns about an end whose distance behind the wall lies in a range, deepest into the gap first.
std::vector<Sample> samples_at(std::span<const HitByWall> hits, const End& end, double from_m, double to_m,
                               double reach_m) {
  std::vector<Sample> samples;
  for (const HitByWall& hit : hits) {
    if (std::abs(hit.along_m - end.at_m) > reach_m) continue;
    if (hit.outside_m < from_m || hit.outside_m > to_m) continue;
    samples.push_back({(hit.along_m - end.at_m) * end.into_gap, hit.outside_m, hit.weight});
  }
  std::sort(samples.begin(), samples.end(),
            [](const Sample& a, const Sample& b) { return a.into_m > b.into_m; });
  return samples;
}

double weight_of(std::span<const Sample> samples) {
  double sum = 0.0;
  for (const Sample& s : samples) sum += s.weight;
  return sum;
}

/// Where the samples, deepest first, reach `weight`.
double position_at(std::span<const Sample> samples, double weight) {
  double sum = 0.0;
  for (const Sample& s : samples) {
    sum += s.weight;
    if (sum >= weight) return s.into_m;
  }
  return samples.back().into_m;
}

/// Where an end is, and how well that is known.
struct EndFit {
  double into_m;
  double sigma_m;
};

/// The jamb itself: the fullest stretch of `reveal_width_m` behind the wall, if it has depth; its median.
std::optional<EndFit> find_reveal(const std::vector<Sample>& samples, const JambFitConfig& config) {
  std::span<const Sample> best;
  double best_weight = 0.0, weight = 0.0;
  for (std::size_t from = 0, to = 0; to < samples.size(); ++to) {
    weight += samples[to].weight;
    while (samples[from].into_m - samples[to].into_m > config.reveal_width_m)
      weight -= samples[from++].weight;
    if (weight <= best_weight) continue;
    best_weight = weight;
    best = std::span(samples).subspan(from, to + 1 - from);
  }
  if (best_weight < config.min_weight) return std::nullopt;
  const auto [near, far] = std::minmax_element(
      best.begin(), best.end(), [](const Sample& a, const Sample& b) { return a.outside_m < b.outside_m; });
  if (far->outside_m - near->outside_m < config.min_reveal_m) return std::nullopt;
  const double spread = best.front().into_m - best.back().into_m;
  return EndFit{position_at(best, 0.5 * best_weight),
                kSteady_m + spread / std::sqrt(12.0 * static_cast<double>(best.size()))};
}

/// How far apart the returns on the face are along the wall, near its end.
double spacing_of(const std::vector<Sample>& samples, double end_m) {
  std::vector<double> gaps;
  for (std::size_t i = 1; i < samples.size() && samples[i].into_m > end_m - kSpacingReach_m; ++i) {
    const double gap = samples[i - 1].into_m - samples[i].into_m;
    if (samples[i - 1].into_m <= end_m && gap > kSameBeam_m) gaps.push_back(gap);
  }
  if (gaps.empty()) return 0.0;
  std::nth_element(gaps.begin(), gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2), gaps.end());
  return gaps[gaps.size() / 2];
}

/// The end of the wall's face: its outermost return, but for strays, and half of the way to the first beam
/// that missed it.
std::optional<EndFit> find_face_end(const std::vector<Sample>& samples, const JambFitConfig& config) {
  const double weight = weight_of(samples);
  if (weight < config.min_weight) return std::nullopt;
  const double end = position_at(samples, kStrayShare * weight), spacing = spacing_of(samples, end);
  return EndFit{end + 0.5 * std::max(0.0, spacing - kFineCell_m),
                kSteady_m + std::max(spacing, kFineCell_m) / std::sqrt(12.0)};
}

EndFit fit_end(std::span<const HitByWall> hits, const End& end, const JambFitConfig& config, double cell_m) {
  const auto face =
      find_face_end(samples_at(hits, end, -config.face_m, config.face_m, config.reach_m), config);
  auto behind = samples_at(hits, end, config.reveal_from_m, config.reveal_to_m, config.reach_m);
  // Where the face goes on, returns behind it are its noise, or those of a jamb with a frame before it.
  if (face) std::erase_if(behind, [&](const Sample& s) { return s.into_m < face->into_m - kFrame_m; });
  if (const auto reveal = find_reveal(behind, config)) return *reveal;
  const bool is_hidden = !face || face->into_m < -kHidden_m;
  return is_hidden ? EndFit{0.0, 2.0 * cell_m / std::sqrt(12.0)} : *face;
}

}  // namespace

std::vector<HitByWall> hits_beside(std::span<const PlacedHits> hits, const Rectangle& rectangle,
                                   const WallInterval& gap, const JambFitConfig& config) {
  const Segment segment = rectangle.wall(gap.wall);
  const Point2 along = segment.direction(), outwards = rectangle.normal(gap.wall);
  ConvexRegion beside;
  beside.cut(segment.from - config.face_m * outwards, outwards)
      .cut(segment.from + config.reveal_to_m * outwards, -outwards)
      .cut(segment.from + (gap.from_m - config.reach_m) * along, along)
      .cut(segment.from + (gap.to_m + config.reach_m) * along, -along);
  std::vector<HitByWall> seen;
  for (const PlacedHits& placed : hits) {
    placed.hits->visit_within(beside, placed.T_map_hits, [&](const Point2& at, double count) {
      const Point2 q = at - segment.from;
      seen.push_back({q.dot(along), q.dot(outwards), count});
      return true;
    });
  }
  return seen;
}

double FittedGap::width_sigma_m() const { return std::hypot(from_sigma_m, to_sigma_m); }

FittedGap fit_jambs(std::span<const HitByWall> hits, const WallInterval& gap, const JambFitConfig& config,
                    double cell_m) {
  JambFitConfig shy = config;  // no end may come near the other one
  shy.reach_m = std::min(config.reach_m, 0.4 * gap.width_m());
  const EndFit from = fit_end(hits, {gap.from_m, 1.0}, shy, cell_m);
  const EndFit to = fit_end(hits, {gap.to_m, -1.0}, shy, cell_m);
  return {{gap.wall, gap.from_m + from.into_m, gap.to_m - to.into_m}, from.sigma_m, to.sigma_m};
}

}  // namespace enfilade::room_detector
