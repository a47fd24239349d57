// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/hit_cells.hpp"

#include <algorithm>
#include <limits>

namespace enfilade::grid_builder {
namespace {

using Iterator = std::vector<CellReturn>::const_iterator;

HitCell mean_of(Iterator first, Iterator last) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (auto it = first; it != last; ++it) sum += to_vector(it->point);
  const auto count = static_cast<double>(last - first);
  const Eigen::Vector3f mean = (sum / count).cast<float>();
  constexpr double kMostCounted = std::numeric_limits<std::uint16_t>::max();
  return {first->cell,
          {mean.x(), mean.y(), mean.z(), static_cast<std::uint16_t>(std::min(count, kMostCounted))}};
}

}  // namespace

std::vector<HitCell> group_by_cell(std::vector<CellReturn> returns) {
  std::stable_sort(returns.begin(), returns.end(),
                   [](const CellReturn& a, const CellReturn& b) { return a.cell < b.cell; });
  std::vector<HitCell> groups;
  for (auto first = returns.cbegin(); first != returns.cend();) {
    const auto last =
        std::find_if(first, returns.cend(), [&](const CellReturn& r) { return r.cell != first->cell; });
    groups.push_back(mean_of(first, last));
    first = last;
  }
  return groups;
}

}  // namespace enfilade::grid_builder
