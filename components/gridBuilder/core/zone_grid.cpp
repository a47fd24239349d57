// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/zone_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "components/gridBuilder/core/ray_walk.hpp"

namespace enfilade::grid_builder {
namespace {

constexpr std::size_t kTilesPerMb = (1 << 20) / Tile::kBytes;
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

CertaintyRule rule_of(const ZoneGridConfig& c) {
  return {log_odds(c.prob_hit), log_odds(c.prob_miss), log_odds(c.clamp_min), log_odds(c.clamp_max),
          log_odds(c.occupied_from)};
}

/// Where a height limit that lies on a border of cells is written with more digits than a double has, it
/// still means the border.
constexpr double kBorderSlack = 1e-6;

}  // namespace

ZoneGrid::ZoneGrid(const ZoneGridConfig& config)
    : config_(checked(config)),
      cells_per_m_(1.0 / config.resolution_m),
      farthest_origin_(kLastCell - std::ceil(config.max_range_m * cells_per_m_) - 1.0),
      lowest_z_(static_cast<int>(std::ceil(config.min_height_m * cells_per_m_ - kBorderSlack))),
      highest_z_(static_cast<int>(std::floor(config.max_height_m * cells_per_m_ + kBorderSlack)) - 1),
      cells_({static_cast<std::size_t>(config.max_memory_mb) * kTilesPerMb, lowest_z_, highest_z_}),
      certainties_(rule_of(config)) {}

LineUpdate ZoneGrid::insert(const ScanLine& line, const std::vector<HitCell>& hits) {
  if (line_stamp_ns_ != line.stamp_ns) begin_line(line.stamp_ns);
  LineUpdate update;
  // Hits first: a cell marked by this line is not carved by it any more.
  update.hits.reserve(hits.size());
  for (const HitCell& group : hits) {
    mark_hit(group.cell, update);
    update.hits.push_back(group.hit);
  }
  for (const Point3f& end : line.hits) carve(line.origin, end, update);
  for (const Point3f& end : line.free_ends) carve(line.origin, end, update);
  return update;
}

void ZoneGrid::begin_line(StampNs stamp_ns) {
  line_stamp_ns_ = stamp_ns;
  for (const Tile::Mark mark : touched_) Tile::take_off(mark);
  touched_.clear();
  hit_.clear();
}

void ZoneGrid::clear() {
  touched_.clear();
  hit_.clear();
  cells_.clear();
  certainties_ = Certainties(rule_of(config_));
  line_stamp_ns_.reset();
}

CellState ZoneGrid::state(const CellIndex& cell) const { return certainties_.state(cells_.find(cell)); }

std::array<CellState, kTileCells> ZoneGrid::tile_states(const CellIndex& cell) const {
  std::array<CellState, kTileCells> states{};
  const Tile* tile = cells_.find_tile(cell);
  for (std::size_t i = 0; tile && i < kTileCells; ++i) states[i] = certainties_.state(tile->cell(i));
  return states;
}

std::optional<double> ZoneGrid::probability(const CellIndex& index) const {
  const Cell cell = cells_.find(index);
  if (cell == kUnexplored) return std::nullopt;
  return 1.0 / (1.0 + std::exp(-static_cast<double>(certainties_.log_odds(cell))));
}

std::vector<GridCell> ZoneGrid::known_cells() const {
  std::vector<std::pair<CellIndex, CellState>> known;
  cells_.for_each_known(
      [&](const CellIndex& index, Cell cell) { known.emplace_back(index, certainties_.state(cell)); });
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
  return group_by_cell(returns);
}

void ZoneGrid::mark_hit(const CellIndex& index, LineUpdate& update) {
  Tile& tile = cells_.tile_of(index);
  if (cells_.is_missing(tile)) {
    ++update.cells_without_memory;
    return;
  }
  const std::size_t offset = offset_in_tile(index);
  if (!tile.is_touched(offset)) {
    set(tile, offset, certainties_.after_hit(tile.cell(offset)), index, update);
  } else if (std::find(hit_.begin(), hit_.end(), index) == hit_.end()) {
    // An earlier part of this line has carved the cell: hits win, so that is taken back.
    set(tile, offset, certainties_.after_hit_for_miss(tile.cell(offset)), index, update);
  }
  hit_.push_back(index);
}

void ZoneGrid::carve(const Point3f& origin, const Point3f& end, LineUpdate& update) {
  if (!usable(origin, end)) return;
  const Eigen::Vector3d from = to_vector(origin) * cells_per_m_;
  Eigen::Vector3d to = to_vector(end) * cells_per_m_;
  if (!within_range(origin, end)) to = from + (to - from).normalized() * (config_.max_range_m * cells_per_m_);
  walk_ray(
      cells_, from, to,
      [&](Tile& tile, std::size_t offset, int x, int y, int z) {
        if (!tile.is_touched(offset))
          set(tile, offset, certainties_.after_miss(tile.cell(offset)), {x, y, z}, update);
      },
      [&](const Tile& tile) { update.cells_without_memory += cells_.is_missing(tile); });
}

/// `next` is what Certainties told.
void ZoneGrid::set(Tile& tile, std::size_t offset, Cell next, const CellIndex& index, LineUpdate& update) {
  const auto cell = static_cast<Cell>(next & ~Certainties::kStateChanges);
  if (cell != next) update.changes.push_back(to_grid_cell(index, certainties_.state(cell)));
  touched_.push_back(tile.set(offset, cell));
}

bool ZoneGrid::usable(const Point3f& origin, const Point3f& end) const {
  const Eigen::Vector3d from = to_vector(origin) * cells_per_m_;
  return from.cwiseAbs().maxCoeff() < farthest_origin_ && to_vector(end).allFinite();
}

bool ZoneGrid::within_range(const Point3f& origin, const Point3f& end) const {
  return (to_vector(end) - to_vector(origin)).squaredNorm() <= config_.max_range_m * config_.max_range_m;
}

}  // namespace enfilade::grid_builder
