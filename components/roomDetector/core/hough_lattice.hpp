// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "interfaces/geometry/rectangle.hpp"

namespace enfilade::room_detector {

struct HoughConfig {
  double theta_step_deg = 1.0;  ///< of θ, (0, 45]
  double step_m = 0.05;         ///< of d and p, [0.02, 0.5]
  double range_m = 16.0;        ///< d and p run from -range to +range about the origin of the space
};

/// A rectangle of the discrete Hough space: the paper's (α, d₁₂, d₂₃, d₃₄, d₄₁) as indices, d12 < d34 and d41
/// < d23. d₁₂ and d₃₄ count along direction α, d₂₃ and d₄₁ along α + π/2. Ordered lexicographically: the
/// first of equally good ones wins.
struct BinRectangle {
  int alpha = 0;
  int d12 = 0, d34 = 0;
  int d41 = 0, d23 = 0;

  auto operator<=>(const BinRectangle&) const = default;
};

/// The discrete values of θ, d and p.
///
/// θ takes the multiples of its step in [-π/4, π/4) only. The paper's range [-π/2, π/2] describes each
/// rectangle twice: turning α by π/2 renames the sides, and the row H(α + π/2, d, ·) is the column of the
/// plane of α mirrored (see README).
class HoughLattice {
 public:
  explicit HoughLattice(const HoughConfig& config)
      : step_m_(config.step_m),
        bins_per_m_(1.0 / config.step_m),
        theta_step_rad_(radians(config.theta_step_deg)),
        first_(static_cast<int>(std::ceil(-0.25 * kPi / theta_step_rad_ - 1e-9))),
        angles_(static_cast<int>(std::ceil(0.25 * kPi / theta_step_rad_ - 1e-9)) - first_),
        half_(static_cast<int>(std::ceil(config.range_m / step_m_ - 1e-9))) {}

  int angles() const { return angles_; }
  double alpha_rad(int angle) const { return (first_ + angle) * theta_step_rad_; }
  double theta_step_rad() const { return theta_step_rad_; }

  int bins() const { return 2 * half_; }
  double step_m() const { return step_m_; }
  /// Index of the bin that holds d (or p); outside [0, bins()) where the space ends.
  int bin(double d_m) const { return binning()(d_m); }
  struct Binning {
    static constexpr int kShift = 1 << 20;  // so that cutting off rounds down
    double bins_per_m, shift;
    int operator()(double d_m) const { return static_cast<int>(d_m * bins_per_m + shift) - kShift; }
  };
  Binning binning() const { return {bins_per_m_, static_cast<double>(half_ + Binning::kShift)}; }
  /// Centre of a bin.
  double value_m(int bin) const { return (bin - half_ + 0.5) * step_m_; }
  bool holds(int bin) const { return bin >= 0 && bin < bins(); }

  /// Eq. 10–13, in the frame of the space. Our width is the extent along α, which the paper calls h.
  Rectangle rectangle(const BinRectangle& r) const {
    const double alpha = alpha_rad(r.alpha);
    const Point2 centre =
        rotate(alpha, {0.5 * (value_m(r.d12) + value_m(r.d34)), 0.5 * (value_m(r.d23) + value_m(r.d41))});
    return {alpha, centre.x(), centre.y(), (r.d34 - r.d12) * step_m_, (r.d23 - r.d41) * step_m_};
  }

 private:
  double step_m_;
  double bins_per_m_;
  double theta_step_rad_;
  int first_;
  int angles_;
  int half_;
};

}  // namespace enfilade::room_detector
