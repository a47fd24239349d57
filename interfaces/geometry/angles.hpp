// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

namespace enfilade {

inline constexpr double kPi = std::numbers::pi;

constexpr double radians(double degrees) { return degrees * kPi / 180.0; }
constexpr double degrees(double radians) { return radians * 180.0 / kPi; }

/// The same angle in [-π, π).
inline double wrap_to_pi(double angle_rad) {
  return angle_rad - 2.0 * kPi * std::floor((angle_rad + kPi) / (2.0 * kPi));
}

/// The same angle modulo a quarter turn, in [-π/4, π/4): the orientation of a rectangle whose sides have no
/// names.
inline double wrap_to_quarter(double angle_rad) {
  return angle_rad - 0.5 * kPi * std::floor((angle_rad + 0.25 * kPi) / (0.5 * kPi));
}

}  // namespace enfilade
