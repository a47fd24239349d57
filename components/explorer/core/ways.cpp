// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/ways.hpp"

#include <utility>

namespace enfilade::explorer {

Ways::Ways(FloorMap map, const PathPlannerConfig& config, const Point2& start)
    : map_(std::move(map)), config_(config), start_(start), usual_(map_, config_, start_) {}

const Reach& Ways::narrow() {
  if (config_.narrow_radius_m >= config_.hard_radius_m) return usual_;
  if (!narrow_) {
    PathPlannerConfig narrow = config_;
    narrow.hard_radius_m = config_.narrow_radius_m;
    narrow_.emplace(fine_map_.emplace(map_.refined()), narrow, start_);
  }
  return *narrow_;
}

}  // namespace enfilade::explorer
