// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/config_values.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace enfilade {
namespace {

template <class T>
std::string format(T value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

/// `kind` as in "a number", "a whole number".
template <class T>
Parsed<T> parse_in_range(const std::string& text, T lowest, T highest, const std::string& kind) {
  std::string_view digits = text;
  if (digits.starts_with('+') && !digits.starts_with("+-"))
    digits.remove_prefix(1);  // YAML's, unknown to from_chars
  const std::string advice = ", write " + kind + " from " + format(lowest) + " to " + format(highest);
  T value{};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::invalid_argument || end != digits.data() + digits.size()) {
    return {{}, "'" + text + "' is not " + kind + advice};
  }
  if constexpr (std::is_floating_point_v<T>) {
    if (error == std::errc{} && !std::isfinite(value)) return {{}, "'" + text + "' is not finite" + advice};
  }
  if (error != std::errc{} || value < lowest || value > highest)
    return {{}, text + " is out of range" + advice};
  return {value, {}};
}

}  // namespace

Parsed<double> parse_number(const std::string& text, double lowest, double highest) {
  for (const char* name : {".inf", "+.inf", "-.inf", ".nan", ".Inf", ".NaN"}) {  // YAML's spellings
    if (text == name)
      return parse_in_range<double>(text.substr(text.find('.') + 1), lowest, highest, "a number");
  }
  return parse_in_range<double>(text, lowest, highest, "a number");
}

Parsed<int> parse_integer(const std::string& text, int lowest, int highest) {
  return parse_in_range<int>(text, lowest, highest, "a whole number");
}

Parsed<bool> parse_flag(const std::string& text) {
  if (text == "true") return {true, {}};
  if (text == "false") return {false, {}};
  return {{}, "'" + text + "' is neither true nor false, write one of these"};
}

Parsed<std::size_t> parse_choice(const std::string& text, const std::vector<std::string>& allowed) {
  const auto found = std::ranges::find(allowed, text);
  if (found != allowed.end()) return {static_cast<std::size_t>(found - allowed.begin()), {}};
  std::string names;
  for (const std::string& name : allowed) names += (names.empty() ? "" : ", ") + name;
  return {{}, "'" + text + "' is unknown, write one of: " + names};
}

std::string format_number(double value) { return format(value); }

}  // namespace enfilade
