// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tools/report/evaluation.hpp"
#include "tools/report/run_recorder.hpp"

namespace enfilade::report {

/// One run, ready to be shown.
struct Report {
  std::string world;
  double wall_time_s = 0.0;
  RunRecord record;
  Evaluation evaluation;
};

Report make_report(const RunRecord& record, const simulator::WorldTruth& truth, const std::string& world,
                   double wall_time_s);

/// The run as JSON, world frame. Two runs of one seed differ in `wall_time_s` alone.
std::string to_json(const Report& report);

/// The closing table: each room and door, measured, true, error.
std::string to_table(const Report& report);

/// `report.json`, `floorplan.svg`, `room<N>-scan<M>.svg` into `folder`, which is made if need be. Throws
/// std::runtime_error naming the file that cannot be written.
void write_files(const Report& report, const std::string& folder);

}  // namespace enfilade::report
