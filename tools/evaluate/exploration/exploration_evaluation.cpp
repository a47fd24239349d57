// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/exploration/exploration_evaluation.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "tools/launch/composed_run.hpp"
#include "tools/support/files.hpp"
#include "tools/support/scratch_folder.hpp"

namespace enfilade::evaluate {
namespace {

ExplorationRow row_of(std::uint64_t seed, const report::Report& report) {
  const report::RunRecord& record = report.record;
  const report::Metrics& m = report.evaluation.metrics;
  ExplorationRow row{.seed = seed, .finished = record.finished(), .ended_with = record.exploration.activity};
  row.rooms_true = m.rooms_true.value_or(0);
  row.rooms_found = m.rooms_found;
  row.doors_true = m.doors_true.value_or(0);
  row.doors_found = m.doors_found;
  for (const report::RoomReport& room : report.evaluation.rooms) row.rooms_right += room.truth ? 1 : 0;
  for (const report::DoorReport& door : report.evaluation.doors) row.doors_right += door.truth ? 1 : 0;
  row.collisions = static_cast<int>(record.ground_truth.collisions);
  row.size_error_mean_m = m.size_error_mean_m;
  row.size_error_max_m = m.size_error_max_m;
  row.centre_error_mean_m = m.center_error_mean_m;
  row.sim_time_s = seconds(record.exploration.stamp_ns);
  row.wall_time_s = report.wall_time_s;
  return row;
}

}  // namespace

std::vector<ExplorationRow> evaluate_explorations(const ExplorationConfig& config,
                                                  const std::function<void(const ExplorationRow&)>& tell) {
  std::optional<ScratchFolder> scratch;
  std::filesystem::path folder = config.worlds;
  if (folder.empty()) folder = scratch.emplace().path();
  make_folder(folder);
  std::vector<ExplorationRow> rows;
  for (int i = 0; i < config.buildings; ++i) {
    BuildingSpec spec = config.spec;
    spec.seed += static_cast<std::uint64_t>(i);
    const std::filesystem::path world = folder / fmt::format("random_{}.yaml", spec.seed);
    write_file(world, world_yaml(random_building(spec)));
    if (config.only_write) continue;
    const ComposedRunOptions options{.world = world,
                                     .seed = spec.seed,
                                     .settings = config.settings,
                                     .max_sim_time_s = config.max_sim_time_s};
    rows.push_back(row_of(spec.seed, run_composed(options)));
    tell(rows.back());
  }
  return rows;
}

bool is_flawless(const ExplorationRow& row) {
  return row.finished && row.collisions == 0 && row.rooms_right == row.rooms_true &&
         row.rooms_found == row.rooms_right && row.doors_right == row.doors_true &&
         row.doors_found == row.doors_right;
}

ExplorationTotals sum_up(const std::vector<ExplorationRow>& rows) {
  ExplorationTotals totals{.buildings = static_cast<int>(rows.size())};
  double rooms = 0.0;
  for (const ExplorationRow& row : rows) {
    totals.finished += row.finished ? 1 : 0;
    totals.flawless += is_flawless(row) ? 1 : 0;
    totals.rooms_true += row.rooms_true;
    totals.rooms_found += row.rooms_found;
    totals.rooms_right += row.rooms_right;
    totals.doors_true += row.doors_true;
    totals.doors_found += row.doors_found;
    totals.doors_right += row.doors_right;
    totals.collisions += row.collisions;
    totals.size_error_mean_m += row.size_error_mean_m.value_or(0.0) * row.rooms_right;
    totals.size_error_max_m = std::max(totals.size_error_max_m, row.size_error_max_m.value_or(0.0));
    rooms += row.rooms_right;
  }
  if (rooms > 0.0) totals.size_error_mean_m /= rooms;
  return totals;
}

}  // namespace enfilade::evaluate
