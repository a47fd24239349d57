// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/zone_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "components/gridBuilder/core/ray_walk.hpp"

namespace enfilade::grid_builder {
namespace {

constexpr std::size_t kTilesPerMb = 32;
/// Cells travel as 16-bit numbers.
constexpr double kLastCell = std::numeric_limits<std::int16_t>::max();

float log_odds(double probability) { return static_cast<float>(std::log(probability / (1.0 - probability))); }

void check(bool holds, const char* sentence) {
  if (!holds) throw std::invalid_argument(sentence);
}

const ZoneGridConfig& checked(const ZoneGridConfig& c) {
  check(c.resolution_m >= 0.01 && c.resolution_m <= 1.0, "resolution_m must lie in 0.01 … 1");
  check(c.prob_hit > 0.5 && c.prob_hit < 1.0, "prob_hit must lie between 0.5 and 1");
  check(c.prob_miss > 0.0 && c.prob_miss < 0.5, "prob_miss must lie between 0 and 0.5");
  check(c.clamp_min > 0.0 && c.clamp_min < c.occupied_from, "clamp_min must lie between 0 and occupied_from");
  check(c.clamp_max < 1.0 && c.clamp_max > c.occupied_from, "clamp_max must lie between occupied_from and 1");
  check(c.max_range_m > 0.0 && c.max_range_m <= 100.0, "max_range_m must lie in 0 … 100");
  check(c.max_height_m > c.min_height_m, "max_height_m must be greater than min_height_m");
  check(c.max_memory_mb >= 1, "max_memory_mb must be at least 1");
  return c;
}

/// Where a height limit that lies on a border of cells is written with more digits than a double has, it
/// still means the border.
constexpr double kBorderSlack = 1e-6;

}  // namespace

ZoneGrid::ZoneGrid(const ZoneGridConfig& config)
    : config_(checked(config)),
      cells_per_m_(1.0 / config.resolution_m),
      farthest_origin_(kLastCell - std::ceil(config.max_range_m * cells_per_m_) - 1.0),
      hit_log_odds_(log_odds(config.prob_hit)),
      miss_log_odds_(log_odds(config.prob_miss)),
      lowest_log_odds_(log_odds(config.clamp_min)),
      highest_log_odds_(log_odds(config.clamp_max)),
      occupied_log_odds_(log_odds(config.occupied_from)),
      lowest_z_(static_cast<int>(std::ceil(config.min_height_m * cells_per_m_ - kBorderSlack))),
      highest_z_(static_cast<int>(std::floor(config.max_height_m * cells_per_m_ + kBorderSlack)) - 1),
      cells_(static_cast<std::size_t>(config.max_memory_mb) * kTilesPerMb) {}

LineUpdate ZoneGrid::insert(const ScanLine& line) {
  if (line_stamp_ns_ != line.stamp_ns) ++line_;
  line_stamp_ns_ = line.stamp_ns;

  LineUpdate update;
  // Hits first: a cell marked by this line is not carved by it any more.
  for (const HitCell& group : hit_cells(line)) {
    mark_hit(group.cell, update);
    update.hits.push_back(group.hit);
  }
  for (const Point3f& end : line.hits) carve(line.origin, end, update);
  for (const Point3f& end : line.free_ends) carve(line.origin, end, update);
  std::sort(update.changes.begin(), update.changes.end(), [](const GridCell& a, const GridCell& b) {
    return CellIndex{a.x, a.y, a.z} < CellIndex{b.x, b.y, b.z};
  });
  return update;
}

void ZoneGrid::clear() {
  cells_.clear();
  line_ = 0;
  line_stamp_ns_.reset();
}

CellState ZoneGrid::state(const CellIndex& cell) const {
  const Cell* known = cells_.find(cell);
  return known ? state_of(*known) : CellState::kUnexplored;
}

std::optional<double> ZoneGrid::probability(const CellIndex& cell) const {
  const Cell* known = cells_.find(cell);
  if (!known) return std::nullopt;
  return 1.0 / (1.0 + std::exp(-static_cast<double>(known->log_odds)));
}

std::vector<GridCell> ZoneGrid::known_cells() const {
  std::vector<std::pair<CellIndex, CellState>> known;
  cells_.for_each_known(
      [&](const CellIndex& index, const Cell& cell) { known.emplace_back(index, state_of(cell)); });
  std::sort(known.begin(), known.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<GridCell> cells;
  cells.reserve(known.size());
  for (const auto& [index, state] : known) cells.push_back(to_grid_cell(index, state));
  return cells;
}

std::vector<HitCell> ZoneGrid::hit_cells(const ScanLine& line) const {
  std::vector<CellReturn> returns;
  returns.reserve(line.hits.size());
  for (const Point3f& end : line.hits) {
    if (!usable(line.origin, end) || !within_range(line.origin, end)) continue;
    const CellIndex cell = cell_at(end);
    if (within_height(cell)) returns.push_back({cell, end});
  }
  return group_by_cell(std::move(returns));
}

void ZoneGrid::mark_hit(const CellIndex& index, LineUpdate& update) {
  Cell* cell = cells_.touch(index);
  if (!cell) {
    ++update.cells_without_memory;
    return;
  }
  const std::uint32_t missed = 2 * line_, hit = missed + 1;
  if (cell->touched == hit) return;
  // An earlier part of this line has carved the cell: hits win, so that is taken back.
  const float taken_back = cell->touched == missed ? miss_log_odds_ : 0.0F;
  add(index, *cell, hit_log_odds_ - taken_back, update);
  cell->touched = hit;
}

void ZoneGrid::carve(const Point3f& origin, const Point3f& end, LineUpdate& update) {
  if (!usable(origin, end)) return;
  const Eigen::Vector3d from = to_vector(origin) * cells_per_m_;
  Eigen::Vector3d to = to_vector(end) * cells_per_m_;
  if (!within_range(origin, end)) to = from + (to - from).normalized() * (config_.max_range_m * cells_per_m_);

  const std::uint32_t missed = 2 * line_;
  walk_ray(from, to, [&](const CellIndex& index) {
    if (!within_height(index)) return;
    Cell* cell = cells_.touch(index);
    if (!cell) {
      ++update.cells_without_memory;
    } else if (cell->touched < missed) {
      add(index, *cell, miss_log_odds_, update);
      cell->touched = missed;
    }
  });
}

/// One step of certainty, clamped; notes the cell where its state changes. The caller notes the touch.
void ZoneGrid::add(const CellIndex& index, Cell& cell, float step, LineUpdate& update) const {
  const CellState before = cell.known() ? state_of(cell) : CellState::kUnexplored;
  cell.log_odds = std::clamp(cell.log_odds + step, lowest_log_odds_, highest_log_odds_);
  const CellState after = state_of(cell);
  if (after != before) update.changes.push_back(to_grid_cell(index, after));
}

bool ZoneGrid::usable(const Point3f& origin, const Point3f& end) const {
  const Eigen::Vector3d from = to_vector(origin) * cells_per_m_;
  return from.cwiseAbs().maxCoeff() < farthest_origin_ && to_vector(end).allFinite();
}

bool ZoneGrid::within_range(const Point3f& origin, const Point3f& end) const {
  return (to_vector(end) - to_vector(origin)).squaredNorm() <= config_.max_range_m * config_.max_range_m;
}

CellState ZoneGrid::state_of(const Cell& cell) const {
  return cell.log_odds >= occupied_log_odds_ ? CellState::kOccupied : CellState::kFree;
}

}  // namespace enfilade::grid_builder
