// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/distance_field.hpp"

#include <cmath>
#include <cstddef>

namespace enfilade::explorer {
namespace {

constexpr double kFar = 1e10;

/// Lower envelope of the parabolas f(q) + (p - q)², written back over f.
class Envelope {
 public:
  explicit Envelope(std::size_t longest) : vertex_(longest), border_(longest + 1), value_(longest) {}

  void transform(double* f, std::size_t n, std::size_t stride) {
    for (std::size_t i = 0; i < n; ++i) value_[i] = f[i * stride];
    std::size_t k = 0;
    vertex_[0] = 0;
    border_[0] = -kFar;
    border_[1] = kFar;
    for (std::size_t q = 1; q < n; ++q) {
      double s = meeting(q, vertex_[k]);
      while (k > 0 && s <= border_[k]) s = meeting(q, vertex_[--k]);
      if (s > border_[k]) ++k;
      vertex_[k] = q;
      border_[k] = s;
      border_[k + 1] = kFar;
    }
    k = 0;
    for (std::size_t p = 0; p < n; ++p) {
      while (border_[k + 1] < static_cast<double>(p)) ++k;
      const double d = static_cast<double>(p) - static_cast<double>(vertex_[k]);
      f[p * stride] = d * d + value_[vertex_[k]];
    }
  }

 private:
  double meeting(std::size_t q, std::size_t v) const {
    const double a = static_cast<double>(q), b = static_cast<double>(v);
    return (value_[q] + a * a - value_[v] - b * b) / (2.0 * (a - b));
  }

  std::vector<std::size_t> vertex_;
  std::vector<double> border_, value_;
};

}  // namespace

std::vector<float> distance_field(const std::vector<std::uint8_t>& set, int width, int height) {
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  // Smaller than the borders of the envelope, so that rows without a set cell stay well defined.
  constexpr double kUnset = 1e8;
  std::vector<double> squared(set.size());
  for (std::size_t i = 0; i < set.size(); ++i) squared[i] = set[i] ? 0.0 : kUnset;
  Envelope envelope(w > h ? w : h);
  for (std::size_t x = 0; x < w && h > 0; ++x) envelope.transform(&squared[x], h, w);
  for (std::size_t y = 0; y < h && w > 0; ++y) envelope.transform(&squared[y * w], w, 1);
  std::vector<float> distance(squared.size());
  for (std::size_t i = 0; i < squared.size(); ++i) distance[i] = static_cast<float>(std::sqrt(squared[i]));
  return distance;
}

}  // namespace enfilade::explorer
