// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/gap_runs.hpp"

namespace enfilade::room_detector {
namespace {

/// Runs of free slices within `gap`, bridging up to `tolerance` others.
std::vector<Run> free_runs(const std::vector<SliceKind>& kinds, const Run& gap, const GapLengths& lengths) {
  std::vector<Run> runs;
  for (std::size_t i = gap.from; i < gap.to; ++i) {
    if (kinds[i] != SliceKind::kFree) continue;
    if (!runs.empty() && i - runs.back().to <= lengths.tolerance) {
      runs.back().to = i + 1;
    } else {
      runs.push_back({i, i + 1});
    }
  }
  std::erase_if(runs, [&](const Run& run) { return run.size() < lengths.min_open; });
  return runs;
}

Gap take_apart(const std::vector<SliceKind>& kinds, const Run& run, const GapLengths& lengths) {
  Gap gap{free_runs(kinds, run, lengths), {}};
  std::size_t at = run.from;
  for (Run& open : gap.open) {
    if (open.from - at < lengths.min_rest) {
      open.from = at;
    } else {
      gap.rest.push_back({at, open.from});
    }
    at = open.to;
  }
  if (run.to == at) return gap;
  if (!gap.open.empty() && run.to - at < lengths.min_rest) {
    gap.open.back().to = run.to;
  } else {
    gap.rest.push_back({at, run.to});
  }
  return gap;
}

}  // namespace

std::vector<Gap> find_gaps(const std::vector<SliceKind>& kinds, const GapLengths& lengths) {
  std::vector<Gap> gaps;
  for (std::size_t i = 0; i < kinds.size();) {
    if (kinds[i] == SliceKind::kWall) {
      ++i;
      continue;
    }
    Run run{i, i};
    while (run.to < kinds.size() && kinds[run.to] != SliceKind::kWall) ++run.to;
    gaps.push_back(take_apart(kinds, run, lengths));
    i = run.to;
  }
  return gaps;
}

}  // namespace enfilade::room_detector
