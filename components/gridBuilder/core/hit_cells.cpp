// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/hit_cells.hpp"

#include <algorithm>
#include <limits>

namespace enfilade::grid_builder {
namespace {

/// Returns from ≤ i < to, one after the other, in one cell.
struct Run {
  std::uint64_t key = 0;
  std::uint32_t from = 0, to = 0;
};

/// Sorts as CellIndex does: cells travel as 16-bit numbers.
std::uint64_t key_of(const CellIndex& c) {
  const auto axis = [](int i) { return static_cast<std::uint64_t>(static_cast<std::uint16_t>(i + 32768)); };
  return axis(c.x) << 32 | axis(c.y) << 16 | axis(c.z);
}

/// Neighbouring beams often end in one cell, so there are far fewer runs than returns.
std::vector<Run> runs_of(const std::vector<CellReturn>& returns) {
  std::vector<Run> runs;
  for (std::uint32_t i = 0; i < returns.size(); ++i) {
    if (i == 0 || returns[i].cell != returns[i - 1].cell) runs.push_back({key_of(returns[i].cell), i, i});
    runs.back().to = i + 1;
  }
  std::sort(runs.begin(), runs.end(),
            [](const Run& a, const Run& b) { return a.key != b.key ? a.key < b.key : a.from < b.from; });
  return runs;
}

using Iterator = std::vector<Run>::const_iterator;

HitCell mean_of(const std::vector<CellReturn>& returns, Iterator first, Iterator last) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0.0;
  for (auto run = first; run != last; ++run) {
    for (std::uint32_t i = run->from; i < run->to; ++i) sum += to_vector(returns[i].point);
    count += run->to - run->from;
  }
  const Eigen::Vector3f mean = (sum / count).cast<float>();
  constexpr double kMostCounted = std::numeric_limits<std::uint16_t>::max();
  return {returns[first->from].cell,
          {mean.x(), mean.y(), mean.z(), static_cast<std::uint16_t>(std::min(count, kMostCounted))}};
}

}  // namespace

std::vector<HitCell> group_by_cell(const std::vector<CellReturn>& returns) {
  const std::vector<Run> runs = runs_of(returns);
  std::vector<HitCell> groups;
  groups.reserve(runs.size());
  for (auto first = runs.cbegin(); first != runs.cend();) {
    const auto last = std::find_if(first, runs.cend(), [&](const Run& run) { return run.key != first->key; });
    groups.push_back(mean_of(returns, first, last));
    first = last;
  }
  return groups;
}

}  // namespace enfilade::grid_builder
