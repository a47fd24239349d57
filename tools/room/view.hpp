// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/room/survey.hpp"

namespace enfilade::room {

/// What of `survey` a robot sees that has just come to `place` and turns about there: the columns that a
/// level beam reaches at some height, through free cells and as far as the first occupied ones. A building
/// fused into one grid shows what lies behind every wall; a robot, whose grid is emptied when it enters a
/// room (section IV), never sees that.
Survey seen_from(const Point2& place, const Survey& survey);

}  // namespace enfilade::room
