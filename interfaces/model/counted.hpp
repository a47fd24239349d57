// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <string>

namespace enfilade {

/// "1 door", "2 doors".
template <std::integral Count>
std::string counted(Count n, const std::string& thing) {
  return std::to_string(n) + " " + thing + (n == 1 ? "" : "s");
}

}  // namespace enfilade
