// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "interfaces/model/grid.hpp"

namespace enfilade::grid_builder {

/// What a cell remembers: the number of its certainty, in 15 bits.
using Cell = std::uint16_t;
inline constexpr Cell kUnexplored = 0;

/// How certainty moves: log-odds per hit and miss, and where they stop.
struct CertaintyRule {
  float hit = 0, miss = 0, lowest = 0, highest = 0, occupied_from = 0;
};

/// The log-odds that cells have come to, numbered in the order of first sight. They are the sums that floats
/// give, and few: cells share the history "seen five times, then missed twice". A number takes less memory
/// than the sum, and what follows from it need be worked out only once.
class Certainties {
 public:
  static constexpr Cell kStateChanges = 0x8000;

  explicit Certainties(const CertaintyRule& rule);

  /// The number after one more miss or hit; with bit kStateChanges where free, occupied and unexplored
  /// change.
  Cell after_miss(Cell number) {
    const Cell next = steps_[number].miss;
    return next != kUnexplored ? next : step(number, rule_.miss);
  }
  Cell after_hit(Cell number) {
    const Cell next = steps_[number].hit;
    return next != kUnexplored ? next : step(number, rule_.hit);
  }
  /// After a hit by a line that has counted as a miss before.
  Cell after_hit_for_miss(Cell number) {
    return number_of(number, log_odds_[number] + (rule_.hit - rule_.miss));
  }

  float log_odds(Cell number) const { return log_odds_[number]; }
  CellState state(Cell number) const {
    if (number == kUnexplored) return CellState::kUnexplored;
    return log_odds_[number] >= rule_.occupied_from ? CellState::kOccupied : CellState::kFree;
  }

 private:
  struct Steps {
    Cell miss = kUnexplored, hit = kUnexplored;  ///< kUnexplored: not worked out yet
  };

  Cell step(Cell number, float by);
  Cell number_of(Cell before, float log_odds);
  Cell find_or_add(float log_odds);

  CertaintyRule rule_;
  std::vector<float> log_odds_;
  std::vector<Steps> steps_;
  std::map<float, Cell> numbers_;
};

}  // namespace enfilade::grid_builder
