// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "components/explorer/core/projected_grid.hpp"

namespace enfilade::explorer {

/// Whether no occupied cell lies between the two points; cells within 1.5 cells of `to` do not count.
/// Unexplored cells are taken to be transparent.
bool is_visible(const ProjectedGrid& grid, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace enfilade::explorer
