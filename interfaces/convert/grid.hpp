// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <enfilade_idl/enfilade_grid.h>

#include "interfaces/convert/common.hpp"
#include "interfaces/model/grid.hpp"

namespace enfilade::wire {

own::GridChange_ to_wire(const GridChange& change);
GridChange from_wire(const own::GridChange_& change);
own::ScanHits_ to_wire(const ScanHits& hits);
ScanHits from_wire(const own::ScanHits_& hits);

}  // namespace enfilade::wire
