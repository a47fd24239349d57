// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/nearest.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace enfilade {
namespace {

std::string_view last_part(std::string_view key) {
  const std::size_t dot = key.rfind('.');
  return dot == std::string_view::npos ? key : key.substr(dot + 1);
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    int diagonal = std::exchange(row[0], static_cast<int>(i) + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const int change = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({change, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

std::optional<std::string> find_nearest(std::string_view text, const std::vector<std::string>& candidates) {
  const int limit = std::max(2, static_cast<int>(last_part(text).size()) / 3);
  std::optional<std::string> nearest;
  int least = limit + 1;
  for (const std::string& candidate : candidates) {
    const int whole = edit_distance(text, candidate);
    const int part = 1 + edit_distance(last_part(text), last_part(candidate));
    if (const int distance = std::min(whole, part); distance < least) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

}  // namespace enfilade
