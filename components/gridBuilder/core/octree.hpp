// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "components/gridBuilder/core/zone_grid.hpp"

namespace octomap {
class OcTree;
}

namespace enfilade::grid_builder {

/// An empty OcTree with the grid's resolution and sensor model.
std::unique_ptr<octomap::OcTree> make_octree(const ZoneGridConfig& config);

/// The grid as an OcTree for storage and exchange: the same cells with the same log-odds.
std::unique_ptr<octomap::OcTree> to_octree(const ZoneGrid& grid);

}  // namespace enfilade::grid_builder
