// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace enfilade {

constexpr double square(double value) { return value * value; }

}  // namespace enfilade
