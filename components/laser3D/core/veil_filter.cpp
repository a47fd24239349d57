// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/veil_filter.hpp"

#include <cmath>

namespace enfilade::laser_3d {
namespace {

/// Share of a steep surface's own step that the next one may differ from the straight continuation.
constexpr double kSteepness = 0.3;

/// Whether beam `i` goes on where the two beams `next` and `next + (next - i)` on one side of it point to.
bool continues(const LaserScan& scan, std::ptrdiff_t i, std::ptrdiff_t step, double min_jump_m) {
  const std::ptrdiff_t beams = std::ssize(scan.ranges_m);
  const std::ptrdiff_t near = i + step, far = i + 2 * step;
  if (near < 0 || near >= beams) return false;
  const double r = scan.ranges_m[static_cast<std::size_t>(i)],
               r_near = scan.ranges_m[static_cast<std::size_t>(near)];
  if (!std::isfinite(r_near)) return false;
  const double jump_m = std::abs(r - r_near);
  if (jump_m < min_jump_m) return true;
  if (far < 0 || far >= beams) return false;
  const double r_far = scan.ranges_m[static_cast<std::size_t>(far)];
  if (!std::isfinite(r_far)) return false;
  const double inverse = 2.0 / r_near - 1.0 / r_far;
  return inverse > 0.0 && std::abs(r - 1.0 / inverse) < 0.5 * min_jump_m + kSteepness * jump_m;
}

bool has_return_nearby(const LaserScan& scan, std::ptrdiff_t i) {
  const std::ptrdiff_t beams = std::ssize(scan.ranges_m);
  const auto returns = [&](std::ptrdiff_t k) {
    return k >= 0 && k < beams && std::isfinite(scan.ranges_m[static_cast<std::size_t>(k)]);
  };
  return returns(i - 1) || returns(i + 1);
}

}  // namespace

std::vector<bool> find_veil(const LaserScan& scan, const VeilFilterConfig& config) {
  const std::ptrdiff_t beams = std::ssize(scan.ranges_m);
  std::vector<bool> veil(scan.ranges_m.size(), false);
  for (std::ptrdiff_t i = 0; i < beams; ++i) {
    const auto beam = static_cast<std::size_t>(i);
    if (!std::isfinite(scan.ranges_m[beam]) || !has_return_nearby(scan, i)) continue;
    veil[beam] = !continues(scan, i, -1, config.min_jump_m) && !continues(scan, i, +1, config.min_jump_m);
  }
  return veil;
}

}  // namespace enfilade::laser_3d
