// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "interfaces/model/counted.hpp"
#include "tools/evaluate/graph/graph_evaluation.hpp"

namespace enfilade::evaluate {
namespace {

using Json = nlohmann::ordered_json;

template <class T, class Member>
Json value_or_null(const std::optional<T>& result, Member member) {
  return result ? Json((*result).*member) : Json(nullptr);
}

std::string rmse_lines(const GraphReport& report, const char* format) {
  std::string out;
  for (const RmseRow& row : report.rmse) {
    out += fmt::format(fmt::runtime(format), row.building, row.rooms, row.false_doors, row.before_m,
                       row.after_m, row.predicted_m, row.after_m / row.predicted_m);
  }
  return out;
}

std::string solver_lines(const GraphReport& report, const char* format) {
  std::string out;
  for (const SolverRow& row : report.solvers) {
    out += fmt::format(fmt::runtime(format), row.building, row.rooms, row.loops, row.solver, row.time_ms,
                       row.cost, row.xi_m2, row.rmse_m);
  }
  return out;
}

std::string offices_line(const GraphReport& report) {
  const OfficeResult& o = report.offices;
  return fmt::format(
      "{}, {}: {}, {}, {} modelled twice; "
      "largest error of a room's place {:.2f} m",
      counted(report.config.offices, "identical office"), counted(report.config.seeds, "seed"),
      counted(o.false_closures, "false closure"), counted(o.missed_rooms, "missed room"), o.duplicates,
      o.pose_error_max_m);
}

std::string ring_line(const GraphReport& report) {
  if (report.config.ring_world.empty()) return "Four-room ring: not run";
  if (!report.ring4) return "Four-room ring, odometry 3 % off: the exploration did not end with four rooms";
  return fmt::format("Four-room ring, odometry 3 % off: rooms within {:.3f} m and {:.2f}°",
                     report.ring4->max_m, degrees(report.ring4->max_rad));
}

}  // namespace

std::string to_json(const GraphReport& report) {
  Json json;
  json["grid100_rmse_before_m"] = report.grid100.before_m;
  json["grid100_rmse_after_m"] = report.grid100.after_m;
  json["ring100_rmse_after_m"] = report.ring100.after_m;
  json["ring100_rmse_predicted_m"] = report.ring100.predicted_m;
  json["identical_offices_false_closures"] = report.offices.false_closures;
  json["identical_offices_missed_rooms"] = report.offices.missed_rooms;
  json["ring4_pose_error_max_m"] = value_or_null(report.ring4, &PoseErrors::max_m);
  json["ring4_pose_error_max_rad"] = value_or_null(report.ring4, &PoseErrors::max_rad);
  json["journal_kills"] = value_or_null(report.journal, &JournalResult::kills);
  json["journal_lost_rooms"] = value_or_null(report.journal, &JournalResult::lost_rooms);
  return json.dump(2) + "\n";
}

std::string to_table(const GraphReport& report) {
  std::string out = fmt::format("{:<9} {:>5} {:>6} {:>10} {:>10} {:>12} {:>6}\n", "building", "rooms",
                                "false", "before m", "after m", "predicted m", "ratio");
  out += rmse_lines(report, "{:<9} {:>5} {:>6} {:>10.3f} {:>10.3f} {:>12.3f} {:>6.2f}\n");
  out += fmt::format("\n{:<9} {:>5} {:>5} {:<6} {:>9} {:>10} {:>10} {:>8}\n", "building", "rooms", "loops",
                     "solver", "time ms", "cost", "xi m2", "rmse m");
  out += solver_lines(report, "{:<9} {:>5} {:>5} {:<6} {:>9.1f} {:>10.1f} {:>10.3f} {:>8.3f}\n");
  out += "\n" + offices_line(report) + "\n" + ring_line(report) + "\n";
  if (report.journal)
    out += fmt::format("Journal: {}, {} lost\n", counted(report.journal->kills, "kill"),
                       counted(report.journal->lost_rooms, "room"));
  return out;
}

std::string to_markdown(const GraphReport& report, const std::string& date) {
  std::string out = "<!-- SPDX-License-Identifier: Apache-2.0 -->\n# The graph, measured\n\n";
  out += fmt::format(
      "{}, `enfilade evaluate graph --seeds {}`. Odometry 2 % of the way and 3° per room, door "
      "positions 2 cm, sizes 1 cm, directions 0.5°, walls 0.15 ± 0.05 m thick.\n\n",
      date, report.config.seeds);
  out +=
      "Room positions, RMSE over the seeds against raw odometry and against what the maximum-likelihood "
      "covariance predicts; the first room is fixed, nothing is aligned.\n\n"
      "| building | rooms | false doors | before m | after m | predicted m | ratio "
      "|\n|---|---|---|---|---|---|---|\n";
  out += rmse_lines(report, "| {} | {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.2f} |\n");
  out +=
      "\nCeres against stochastic gradient descent on the same residuals from the same start, one core. The "
      "cost "
      "is ½ Σ ρ, ξ is eq. 21 with the walls' thickness taken out.\n\n"
      "| building | rooms | loops | solver | time ms | cost | ξ m² | RMSE m "
      "|\n|---|---|---|---|---|---|---|---|\n";
  out += solver_lines(report, "| {} | {} | {} | {} | {:.1f} | {:.1f} | {:.3f} | {:.3f} |\n");
  return out + "\n" + offices_line(report) + ".\n\n" + ring_line(report) + ".\n";
}

}  // namespace enfilade::evaluate
