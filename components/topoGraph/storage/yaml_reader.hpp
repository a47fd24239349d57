// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "components/topoGraph/storage/map_file.hpp"

namespace enfilade::topo_graph {

/// Where a piece of YAML comes from, for errors that name the line.
struct YamlSource {
  std::string file;
  int lines_before = 0;  ///< lines of the file before the piece

  /// "file:line: what; what to do". `line` counts from 0 within the piece.
  [[noreturn]] void fail(int line, const std::string& what) const;
};

/// The first document in `text`. Throws MapFileError. (All of them is not asked for: yaml-cpp 0.7 can find
/// new ones in the same few bytes for ever.)
YAML::Node load_yaml(const std::string& text, const YamlSource& source);

/// One value of a YAML file. The source must outlive it.
class YamlValue {
 public:
  YamlValue(YAML::Node node, const YamlSource& source, std::string key)
      : node_(std::move(node)), source_(&source), key_(std::move(key)) {}

  [[noreturn]] void fail(const std::string& what) const;
  /// Refuses what stands after the first document of `text`, which is to end with this value.
  void must_be_on_last_line(std::string_view text) const;

  double number() const;  ///< finite
  std::uint64_t count(std::uint64_t highest) const;
  std::int64_t signed_count() const;
  std::uint32_t id() const;  ///< from 1
  bool flag() const;
  std::string text() const;
  /// Index of the value among `allowed`.
  std::size_t one_of(const std::string_view* first, const std::string_view* last) const;
  std::vector<YamlValue> list() const;

 private:
  friend class YamlMap;
  const std::string& scalar(const char* wanted) const;

  YAML::Node node_;
  const YamlSource* source_;
  std::string key_;
};

/// A map whose keys are taken one after another; `finish` refuses what is left, so nothing in a file is
/// silently ignored.
class YamlMap {
 public:
  explicit YamlMap(const YamlValue& value);

  YamlValue take(const char* key);
  std::optional<YamlValue> take_if_present(const char* key);
  void finish() const;

 private:
  YamlValue value_;

  // Entries are marked, not erased: assigning a YAML::Node changes the document behind it.
  struct Entry {
    std::string key;
    YAML::Node value;
    bool taken = false;
  };
  std::vector<Entry> entries_;
};

}  // namespace enfilade::topo_graph
