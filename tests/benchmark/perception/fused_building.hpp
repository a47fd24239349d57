// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tests/benchmark/perception/random_scans.hpp"

namespace enfilade::bench {

struct FusedBuildings {
  std::vector<SearchInput> inputs;
  std::string label;  ///< which buildings these are
};

/// A robot at 200 places of whole buildings, each fused into one grid and never cleared: the corrected Intel
/// and CSAIL logs under $ENFILADE_DATA (data/ where that is not set), or a made-up office floor
/// where there are none. The one layer of a level scanner stands for the whole wall band.
FusedBuildings fused_inputs(const room_detector::HoughConfig& hough);

}  // namespace enfilade::bench
