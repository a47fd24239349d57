// SPDX-License-Identifier: Apache-2.0
#include "tools/draw/wall_place.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace enfilade::draw {
namespace {

constexpr double kCorner_m = 0.3;  // the text of the next wall stands there
constexpr double kSpace_m = 0.08;  // between a text and what is taken

/// The clear place nearest to the middle: that itself, or one just beside something taken.
std::optional<double> clear_place(double wall_m, int wall, const std::vector<WallInterval>& taken,
                                  double half_m) {
  std::vector<double> places{0.5 * wall_m};
  for (const WallInterval& t : taken) {
    if (t.wall != wall) continue;
    places.push_back(t.from_m - kSpace_m - half_m);
    places.push_back(t.to_m + kSpace_m + half_m);
  }
  std::ranges::sort(places, {}, [wall_m](double place) { return std::abs(place - 0.5 * wall_m); });
  const auto is_clear = [&](double place) {
    if (place < kCorner_m + half_m || place > wall_m - kCorner_m - half_m) return false;
    const double reach_m = half_m + 0.99 * kSpace_m;
    return std::ranges::none_of(taken, [&](const WallInterval& t) {
      return t.wall == wall && place + reach_m > t.from_m && place - reach_m < t.to_m;
    });
  };
  const auto found = std::ranges::find_if(places, is_clear);
  return found == places.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

WallPlace place_dimension(const Rectangle& room, int wall, const std::vector<WallInterval>& taken,
                          double text_m) {
  const double wall_m = room.wall_length_m(wall);
  for (const int candidate : {wall, (wall + 2) % 4})
    if (const auto along_m = clear_place(wall_m, candidate, taken, 0.5 * text_m))
      return {candidate, *along_m};
  return {wall, 0.5 * wall_m, 0.4};
}

}  // namespace enfilade::draw
