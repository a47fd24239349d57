// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace enfilade {

/// A value read from text, or a sentence: what is wrong, what to do.
template <class T>
struct Parsed {
  std::optional<T> value;
  std::string problem;
};

/// Whatever the locale; the whole text or nothing; finite; within the closed range.
Parsed<double> parse_number(const std::string& text, double lowest, double highest);
Parsed<int> parse_integer(const std::string& text, int lowest, int highest);
Parsed<bool> parse_flag(const std::string& text);
/// The index in `allowed`.
Parsed<std::size_t> parse_choice(const std::string& text, const std::vector<std::string>& allowed);

/// The shortest text that reads back as the same number.
std::string format_number(double value);

}  // namespace enfilade
