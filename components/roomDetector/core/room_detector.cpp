// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/room_detector.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace enfilade::room_detector {
namespace {

/// The Hough space is centred on the robot, to the metre, so that rooms far from the zone's origin lie in it
/// and votes need not be cast anew while the robot turns about.
Point2 origin_near(const std::optional<Pose2>& T_zone_base) {
  if (!T_zone_base) return Point2::Zero();
  return {std::round(T_zone_base->x_m), std::round(T_zone_base->y_m)};
}

constexpr double kFarthestPose_m = 1e4;  // from the zone's origin; a pose beyond that is none

std::optional<Pose2> usable(const std::optional<Pose2>& T_zone_base) {
  if (!T_zone_base || !std::isfinite(T_zone_base->yaw_rad)) return std::nullopt;
  const bool is_near =
      std::abs(T_zone_base->x_m) < kFarthestPose_m && std::abs(T_zone_base->y_m) < kFarthestPose_m;
  return is_near ? T_zone_base : std::nullopt;  // NaN compares false
}

constexpr double kLeastWall_m =
    0.3;  // of net evidence, that a room ends there; the corner of another wall is less

/// The nearest rectangle of the space.
std::optional<BinRectangle> bins_of(const Rectangle& r, const HoughSpace& space) {
  const HoughLattice& lattice = space.lattice();
  const double first = lattice.alpha_rad(0);
  const int angle = static_cast<int>(std::lround((r.yaw_rad - first) / lattice.theta_step_rad()));
  const int alpha = std::clamp(angle, 0, lattice.angles() - 1);
  const auto low = space.bins_of(alpha, r.corner(3)), high = space.bins_of(alpha, r.corner(1));
  const bool is_held = lattice.holds(low.d) && lattice.holds(low.p) && lattice.holds(high.d) &&
                       lattice.holds(high.p) && low.d < high.d && low.p < high.p;
  if (!is_held) return std::nullopt;
  return BinRectangle{alpha, low.d, high.d, low.p, high.p};
}

Pose2 correction_of(const Detection& d, std::size_t stand) {
  const auto& corrections = d.diagnostics.corrections;
  return stand < corrections.size() ? corrections[stand] : Pose2{};
}

}  // namespace

RoomDetector::RoomDetector(const RoomDetectorConfig& config, TaskRunner runner)
    : config_(config),
      map_(config.beyond_floor_m),
      votes_(config.votes, config.hough),
      search_(config.search, config.hough, std::move(runner)),
      fitter_(config.fit),
      door_finder_(config.door_finder),
      joint_fitter_(config.joint, config.fit),
      stands_(config.stands) {
  const double step = config.hough.step_m;
  if (config.search.side_min_m < (2.0 * std::round(config.votes.contour_margin_m / step) + 1.0) * step)
    throw std::invalid_argument("side_min_m must be more than twice contour_margin_m, and a step more");
}

void RoomDetector::clear(double resolution_m) {
  map_.clear(resolution_m);
  votes_.clear();
  stands_.clear();
  returns_missed_ = false;
}

void RoomDetector::update(const GridChange& change) { map_.apply(change.cells); }

void RoomDetector::adopt(const GridChange& snapshot) {
  returns_missed_ = !snapshot.cells.empty();
  update(snapshot);
}

void RoomDetector::add_hits(const ScanHits& hits) { stands_.add(hits, map_.resolution_m()); }

Detection RoomDetector::estimate(const std::optional<Pose2>& T_zone_robot) {
  const std::optional<Pose2> T_zone_base = usable(T_zone_robot);
  Detection d;
  band_ = choose_wall_band(map_, config_.band);
  const auto robot = T_zone_base ? std::optional(T_zone_base->translation()) : std::nullopt;
  const HoughSpace& space =
      votes_.update(map_, band_, origin_near(T_zone_base), robot);  // eq. 1–3, steps 1, 2
  stands_.follow(band_);
  const auto best = search_.find_best(space, robot);  // eq. 5–9, step 3
  if (!best || best->score <= 0 || !is_closed(*best)) return d;
  d.diagnostics.search = *best;
  d.diagnostics.coarse = space.rectangle(best->rectangle);  // eq. 10–13, step 4
  complete(d, space);
  return d;
}

Detection RoomDetector::describe(const Rectangle& outline) {
  Detection d;
  if (!votes_.space()) return d;
  const HoughSpace& space = *votes_.space();
  const auto bins = bins_of(canonical(outline).rectangle, space);
  if (!bins) return d;
  const HoughSpace::Terms terms = space.terms(*bins);
  d.diagnostics.search = {.rectangle = *bins, .score = terms.score, .walls = terms.walls};
  d.diagnostics.coarse = canonical(outline).rectangle;
  complete(d, space);
  return d;
}

/// All that follows from the coarse rectangle.
void RoomDetector::complete(Detection& d, const HoughSpace& space) const {
  d.diagnostics.above_furniture = band_.above_furniture;
  d.estimate.found = true;
  d.estimate.score = d.diagnostics.search.score / votes_.unit();
  d.estimate.rectangle = d.diagnostics.coarse;
  if (config_.refine) refine(d, band_);
  find_doors(d, space);  // eq. 14–16
  fit_recent(d);         // r(i+1) of eq. 18–19
}

RoomDiagnostics RoomDetector::explain(const Detection& d) const {
  RoomDiagnostics out;
  out.found = d.estimate.found;
  out.above_furniture = d.diagnostics.above_furniture;
  out.gaps = d.diagnostics.gaps;
  if (!d.estimate.found || !votes_.space()) return out;
  explain_score({*votes_.space(), d.diagnostics.search, votes_.unit()}, out);
  if (d.diagnostics.fit) explain_fit(*d.diagnostics.fit, d.diagnostics.coarse, out);
  return out;
}

/// Whether at least one wall shows how far the room goes each way. One wall alone, or two parallel ones, are
/// a corridor of which no end has been seen.
bool RoomDetector::is_closed(const SearchResult& best) const {
  const auto [h12, h23, h34, h41] = best.walls;
  const double least = votes_.wall(kLeastWall_m, map_.resolution_m());
  return std::max(h12, h34) >= least && std::max(h23, h41) >= least;
}

/// Those in the room, if there are any: what was seen from elsewhere may be the other face of a wall.
std::vector<std::size_t> RoomDetector::stands_in(const Rectangle& room) const {
  std::vector<std::size_t> inside, all;
  for (std::size_t i = 0; i < stands_.all().size(); ++i) {
    all.push_back(i);
    if (room.contains(stands_.all()[i].T_zone_base.translation())) inside.push_back(i);
  }
  return inside.empty() ? all : inside;
}

std::vector<WallPoint> RoomDetector::cells_far_from(const std::vector<StandPoints>& stands,
                                                    const WallBand& band) const {
  std::vector<bool> is_hit(map_.columns().size(), false);
  for (const StandPoints& stand : stands) {
    for (const WallPoint& point : stand.points)
      if (const Column* hit = map_.find(point.position)) is_hit[map_.index_of(*hit)] = true;
  }
  const Levels levels = band.levels();
  std::vector<std::size_t> far;
  for (const std::size_t i : votes_.space()->wall_voters()) {
    const Column& column = map_.columns()[i];
    if (is_hit[i] || count_of(column.occupied & levels) == 0) continue;  // as nearly all
    bool is_beside_hit = false;
    map_.for_each_around(column, [&](std::size_t at) { is_beside_hit |= is_hit[at]; });
    if (!is_beside_hit) far.push_back(i);
  }
  std::sort(far.begin(), far.end());  // voters come and go in any order
  std::vector<WallPoint> points;
  for (const std::size_t i : far) {
    const Column& column = map_.columns()[i];
    points.push_back({map_.centre(column), static_cast<double>(count_of(column.occupied & levels))});
  }
  return points;
}

std::vector<PlacedHits> RoomDetector::jamb_hits(const Detection& d) const {
  std::vector<PlacedHits> hits;
  for (std::size_t i = 0; i < stands_.all().size(); ++i)
    hits.push_back({&stands_.all()[i].fine_hits, correction_of(d, i)});
  return hits;
}

/// None where it is not known what was seen through a gap; of stands put together nobody knows which beam
/// came from where.
std::vector<Sightings> RoomDetector::sightings(const Detection& d) const {
  std::vector<Sightings> seen;
  if (returns_missed_) return seen;
  for (std::size_t i = 0; i < stands_.all().size(); ++i) {
    const Stand& stand = stands_.all()[i];
    if (stand.merged > 0 || stand.hits.empty()) continue;
    const Pose2 correction = correction_of(d, i);
    seen.push_back({correction * stand.T_zone_base.translation(), {&stand.hits, correction}});
  }
  return seen;
}

void RoomDetector::refine(Detection& d, const WallBand& band) const {
  const double reach = 1.5 * std::max(config_.hough.step_m, map_.resolution_m());
  const auto inside = stands_in(d.diagnostics.coarse);
  std::vector<StandPoints> stands;
  for (const std::size_t i : inside)
    stands.push_back({stands_.all()[i].T_zone_base, stands_.all()[i].wall_points});
  const auto cells = cells_far_from(stands, band);
  if (stands.empty()) stands.emplace_back();
  stands.front().points.insert(stands.front().points.end(), cells.begin(), cells.end());
  const auto joint = joint_fitter_.fit(stands, d.diagnostics.coarse, reach);
  if (!joint) return;
  d.diagnostics.fit = joint->room;
  d.diagnostics.corrections.resize(stands_.all().size());
  for (std::size_t i = 0; i < inside.size(); ++i)
    d.diagnostics.corrections[inside[i]] = joint->corrections[i];
  const RectangleFit& fit = *d.diagnostics.fit;
  const auto canonical_fit = canonical(fit.rectangle);
  d.estimate.rectangle = canonical_fit.rectangle;
  auto covariance = fit.covariance;
  if (canonical_fit.quarter_turns % 2 != 0) {  // the sides change names
    covariance.row(3).swap(covariance.row(4));
    covariance.col(3).swap(covariance.col(4));
  }
  d.estimate.covariance.emplace();
  Eigen::Map<Eigen::Matrix<double, 5, 5, Eigen::RowMajor>>(d.estimate.covariance->data()) = covariance;
}

void RoomDetector::find_doors(Detection& d, const HoughSpace& space) const {
  WallGaps gaps = door_finder_.find(map_, d.estimate.rectangle, jamb_hits(d), sightings(d));
  d.diagnostics.gaps = std::move(gaps.diagnostics);
  d.estimate.unexplored_wall_share = gaps.unexplored_share;
  if (config_.doors == DoorMethod::kEvidence) {
    d.estimate.doors = std::move(gaps.doors);
    return;
  }
  const Rectangle& coarse = d.diagnostics.coarse;
  d.estimate.doors =
      rename_walls(find_paper_doors(map_, space.lattice(), space.origin(), coarse, config_.paper_doors),
                   coarse, d.estimate.rectangle);
}

void RoomDetector::fit_recent(Detection& d) const {
  if (stands_.empty()) return;
  d.diagnostics.recent_fit =
      fitter_.fit_pose(stands_.all().back().wall_points, d.estimate.rectangle, config_.joint.reach_m);
  if (d.diagnostics.recent_fit) d.estimate.recent = d.diagnostics.recent_fit->rectangle;
}

}  // namespace enfilade::room_detector
