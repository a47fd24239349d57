// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace enfilade {

/// Least number of single-letter insertions, removals and changes that turn `a` into `b` (Levenshtein).
int edit_distance(std::string_view a, std::string_view b);

/// What of `candidates` the writer of `text` most likely meant; nothing if all are too far off. For dotted
/// keys the last part alone counts as well: "compute_s" is near "period.compute_s".
std::optional<std::string> find_nearest(std::string_view text, const std::vector<std::string>& candidates);

}  // namespace enfilade
