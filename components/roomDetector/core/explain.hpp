// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/roomDetector/core/rectangle_fit.hpp"
#include "components/roomDetector/core/rectangle_search.hpp"
#include "interfaces/model/room_diagnostics.hpp"

namespace enfilade::room_detector {

/// What the search has decided, and on what.
struct Decision {
  const HoughSpace& space;
  const SearchResult& search;
  double unit = 1.0;  ///< of what is reported, in units of the votes: one nat, or one cell
};

/// The terms of the score, side by side, what else could have been, and the plane of the best angle.
void explain_score(const Decision& decision, RoomDiagnostics& out);

/// What the fit did to the walls.
void explain_fit(const RectangleFit& fit, const Rectangle& coarse, RoomDiagnostics& out);

}  // namespace enfilade::room_detector
