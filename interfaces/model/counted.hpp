// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <concepts>
#include <string>

namespace enfilade {

/// "1 door", "2 doors".
template <std::integral Count>
std::string counted(Count n, const std::string& thing) {
  return std::to_string(n) + " " + thing + (n == 1 ? "" : "s");
}

/// Rounded to multiples of 1 / per_unit, for a person to read: never −0.
inline double rounded(double value, double per_unit) { return std::round(value * per_unit) / per_unit + 0.0; }

}  // namespace enfilade
