// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "components/explorer/core/projected_grid.hpp"

namespace enfilade::explorer {

/// Follows gridBuilder's stream of changes: knows when the cells are complete, and when a message was missed.
class ZoneCells {
 public:
  explicit ZoneCells(const ProjectedGridConfig& config) : grid_(config) {}

  enum class Verdict { kTaken, kNeedsSnapshot };
  /// A change of an epoch not seen before starts a new grid; it can be built from changes alone if it starts
  /// with number 0.
  Verdict take(const GridChange& change);
  void take_snapshot(const GridChange& snapshot);

  /// Of the cells in `grid()`; nothing while some are missing.
  std::optional<ZoneTag> tag() const { return complete_ ? tag_ : std::nullopt; }
  const ProjectedGrid& grid() const { return grid_; }

 private:
  ProjectedGrid grid_;
  std::optional<ZoneTag> tag_;
  std::uint64_t sequence_ = 0;
  bool complete_ = false;
};

}  // namespace enfilade::explorer
