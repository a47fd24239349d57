// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/certainties.hpp"

#include <algorithm>
#include <iterator>

namespace enfilade::grid_builder {

Certainties::Certainties(const CertaintyRule& rule) : rule_(rule), log_odds_{0.0F}, steps_(1) {}

Cell Certainties::step(Cell number, float by) {
  const Cell next = number_of(number, log_odds_[number] + by);
  (by > 0.0F ? steps_[number].hit : steps_[number].miss) = next;
  return next;
}

Cell Certainties::number_of(Cell before, float log_odds) {
  const Cell next = find_or_add(std::clamp(log_odds, rule_.lowest, rule_.highest));
  return state(next) == state(before) ? next : static_cast<Cell>(next | kStateChanges);
}

/// When all numbers are given away the nearest one has to do: 32767 of them lie less than a thousandth apart.
Cell Certainties::find_or_add(float log_odds) {
  const auto above = numbers_.lower_bound(log_odds);
  if (above != numbers_.end() && above->first == log_odds) return above->second;
  if (log_odds_.size() < kStateChanges) {
    const auto number = static_cast<Cell>(log_odds_.size());
    log_odds_.push_back(log_odds);
    steps_.emplace_back();
    numbers_.emplace_hint(above, log_odds, number);
    return number;
  }
  if (above == numbers_.begin()) return above->second;
  const auto below = std::prev(above);
  const bool is_above_nearer = above != numbers_.end() && above->first - log_odds < log_odds - below->first;
  return is_above_nearer ? above->second : below->second;
}

}  // namespace enfilade::grid_builder
