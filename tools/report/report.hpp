// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tools/enfilade/report/evaluation.hpp"
#include "tools/enfilade/report/run_recorder.hpp"

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

/// All of `text` or nothing: through a temporary file beside `path`.
void write_file(const std::string& path, const std::string& text);

/// The date in UTC, for the head of a report: 2026-01-31.
std::string today();

}  // namespace enfilade::report
