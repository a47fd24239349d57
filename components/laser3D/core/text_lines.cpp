// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/text_lines.hpp"

#include <charconv>
#include <stdexcept>

namespace enfilade::laser_3d {
namespace {

template <class T>
std::optional<T> parse(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

}  // namespace

void reject(const FileBytes& file, const std::string& what) {
  throw std::runtime_error(file.name + ": " + what);
}

void reject_line(const FileBytes& file, int line, const std::string& what) {
  reject(file, "line " + std::to_string(line) + ": " + what);
}

std::optional<std::string_view> TextLines::next() {
  const std::size_t end = text_.find('\n', offset_);
  if (end == std::string_view::npos) return std::nullopt;
  std::string_view line = text_.substr(offset_, end - offset_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  offset_ = end + 1;
  ++number_;
  return line;
}

std::vector<std::string_view> words(std::string_view line) {
  constexpr std::string_view kBlanks = " \t";
  std::vector<std::string_view> found;
  std::size_t from = line.find_first_not_of(kBlanks);
  while (from != std::string_view::npos) {
    const std::size_t to = line.find_first_of(kBlanks, from);
    found.push_back(line.substr(from, to == std::string_view::npos ? to : to - from));
    from = line.find_first_not_of(kBlanks, to);
  }
  return found;
}

std::optional<double> to_number(std::string_view word) { return parse<double>(word); }
std::optional<std::size_t> to_count(std::string_view word) { return parse<std::size_t>(word); }

}  // namespace enfilade::laser_3d
