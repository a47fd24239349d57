// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "interfaces/model/counted.hpp"
#include "tools/evaluate/exploration/exploration_evaluation.hpp"

namespace enfilade::evaluate {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json row_json(const ExplorationRow& row) {
  return {{"seed", row.seed},
          {"finished", row.finished},
          {"ended_with", row.ended_with},
          {"rooms_true", row.rooms_true},
          {"rooms_found", row.rooms_found},
          {"rooms_right", row.rooms_right},
          {"doors_true", row.doors_true},
          {"doors_found", row.doors_found},
          {"doors_right", row.doors_right},
          {"collisions", row.collisions},
          {"size_error_mean_m", number_or_null(row.size_error_mean_m)},
          {"size_error_max_m", number_or_null(row.size_error_max_m)},
          {"centre_error_mean_m", number_or_null(row.centre_error_mean_m)},
          {"sim_time_s", row.sim_time_s},
          {"wall_time_s", row.wall_time_s}};
}

}  // namespace

std::string to_line(const ExplorationRow& row) {
  return fmt::format(
      "building {:>4}: rooms {}/{} (+{}), doors {}/{} (+{}), {}, size error {:.3f} m at most, "
      "{:.0f} s{}\n",
      row.seed, row.rooms_right, row.rooms_true, row.rooms_found - row.rooms_right, row.doors_right,
      row.doors_true, row.doors_found - row.doors_right, counted(row.collisions, "collision"),
      row.size_error_max_m.value_or(0.0), row.sim_time_s,
      row.finished ? "" : ": not finished, " + row.ended_with);
}

std::string to_text(const ExplorationTotals& t) {
  return fmt::format(
      "{}: {} finished, {} without any flaw; rooms {} of {} (and {} that are none), doors {} of {} "
      "(and {} "
      "that are none), {}; sizes off by {:.1f} mm on average, {:.3f} m at most\n",
      counted(t.buildings, "building"), t.finished, t.flawless, t.rooms_right, t.rooms_true,
      t.rooms_found - t.rooms_right, t.doors_right, t.doors_true, t.doors_found - t.doors_right,
      counted(t.collisions, "collision"), 1e3 * t.size_error_mean_m, t.size_error_max_m);
}

std::string to_json(const std::vector<ExplorationRow>& rows) {
  const ExplorationTotals t = sum_up(rows);
  Json json{{"buildings", t.buildings},
            {"finished", t.finished},
            {"flawless", t.flawless},
            {"rooms_true", t.rooms_true},
            {"rooms_found", t.rooms_found},
            {"rooms_right", t.rooms_right},
            {"doors_true", t.doors_true},
            {"doors_found", t.doors_found},
            {"doors_right", t.doors_right},
            {"collisions", t.collisions},
            {"size_error_mean_m", t.size_error_mean_m},
            {"size_error_max_m", t.size_error_max_m},
            {"runs", Json::array()}};
  for (const ExplorationRow& row : rows) json["runs"].push_back(row_json(row));
  return json.dump(2) + "\n";
}

}  // namespace enfilade::evaluate
