// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "interfaces/model/sensing.hpp"

namespace enfilade::laser_3d {

struct VeilFilterConfig {
  double min_jump_m = 0.08;  ///< a smaller step between neighbouring beams is noise or a surface, > 0
};

/// Finds the returns of beams that were split between two surfaces at an edge: their range lies somewhere
/// between, in mid-air. Such a return jumps from both of its neighbours and continues the surface on neither
/// side, a plane being linear in 1 / range over the beam's angle. A grazing wall or floor continues its own
/// line however steep it is, and is kept.
///
/// One entry a beam, true for what is to be dropped.
std::vector<bool> find_veil(const LaserScan& scan, const VeilFilterConfig& config);

}  // namespace enfilade::laser_3d
