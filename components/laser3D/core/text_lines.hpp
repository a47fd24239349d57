// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace enfilade::laser_3d {

/// A file that was read: what to call it in a complaint, and its bytes.
struct FileBytes {
  std::string name;
  std::string bytes;
};

/// Throws std::runtime_error "name: what".
[[noreturn]] void reject(const FileBytes& file, const std::string& what);
/// Throws std::runtime_error "name: line N: what".
[[noreturn]] void reject_line(const FileBytes& file, int line, const std::string& what);

/// Goes through the lines of a text. A last line without a line end is not given: the file was cut off there.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : text_(text) {}

  std::optional<std::string_view> next();
  int number() const { return number_; }          ///< of the line last given, from 1
  std::size_t offset() const { return offset_; }  ///< where the next line begins
  bool at_end() const { return offset_ == text_.size(); }

 private:
  std::string_view text_;
  std::size_t offset_ = 0;
  int number_ = 0;
};

/// The parts of a line between blanks.
std::vector<std::string_view> words(std::string_view line);
/// The whole word as a number; "nan" and "inf" are numbers.
std::optional<double> to_number(std::string_view word);
/// The whole word as a count.
std::optional<std::size_t> to_count(std::string_view word);

}  // namespace enfilade::laser_3d
