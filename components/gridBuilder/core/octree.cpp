// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/octree.hpp"

#include <octomap/OcTree.h>

namespace enfilade::grid_builder {
namespace {

/// OctoMap counts cells from -32768 on.
constexpr int kKeyOfCellZero = 32768;

octomap::OcTreeKey octree_key_of(const CellIndex& c) {
  const auto key = [](int i) { return static_cast<octomap::key_type>(i + kKeyOfCellZero); };
  return {key(c.x), key(c.y), key(c.z)};
}

}  // namespace

std::unique_ptr<octomap::OcTree> make_octree(const ZoneGridConfig& config) {
  auto tree = std::make_unique<octomap::OcTree>(config.resolution_m);
  tree->setProbHit(config.prob_hit);
  tree->setProbMiss(config.prob_miss);
  tree->setClampingThresMin(config.clamp_min);
  tree->setClampingThresMax(config.clamp_max);
  tree->setOccupancyThres(config.occupied_from);
  return tree;
}

std::unique_ptr<octomap::OcTree> to_octree(const ZoneGrid& grid) {
  auto tree = make_octree(grid.config());
  grid.for_each_known([&tree](const CellIndex& index, float log_odds) {
    tree->setNodeValue(octree_key_of(index), log_odds, true);
  });
  tree->updateInnerOccupancy();
  tree->prune();
  return tree;
}

}  // namespace enfilade::grid_builder
