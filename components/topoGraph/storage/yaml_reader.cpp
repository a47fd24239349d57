// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/storage/yaml_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

namespace enfilade::topo_graph {
namespace {

template <class T>
bool parse(const std::string& text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

void YamlSource::fail(int line, const std::string& what) const {
  throw MapFileError(file + ":" + std::to_string(lines_before + line + 1) + ": " + what +
                     "; mend the line or take an older copy of the file");
}

YAML::Node load_yaml(const std::string& text, const YamlSource& source) {
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    source.fail(error.mark.line, error.msg);
  }
}

void YamlValue::fail(const std::string& what) const { source_->fail(node_.Mark().line, key_ + ": " + what); }

void YamlValue::must_be_on_last_line(std::string_view text) const {
  if (text.ends_with('\n')) text.remove_suffix(1);
  if (node_.Mark().line != std::count(text.begin(), text.end(), '\n'))
    fail("must be the last line: what follows is no part of this");
}

const std::string& YamlValue::scalar(const char* wanted) const {
  if (!node_.IsScalar()) fail(std::string("must be ") + wanted);
  return node_.Scalar();
}

double YamlValue::number() const {
  double value = 0.0;
  if (!parse(scalar("a number"), value) || !std::isfinite(value)) fail("must be a finite number");
  return value;
}

std::uint64_t YamlValue::count(std::uint64_t highest) const {
  std::uint64_t value = 0;
  if (!parse(scalar("a whole number"), value) || value > highest) {
    fail("must be a whole number from 0 to " + std::to_string(highest));
  }
  return value;
}

std::int64_t YamlValue::signed_count() const {
  std::int64_t value = 0;
  if (!parse(scalar("a whole number"), value)) fail("must be a whole number");
  return value;
}

std::uint32_t YamlValue::id() const {
  const std::uint64_t value = count(std::numeric_limits<std::uint32_t>::max());
  if (value == 0) fail("ids count from 1");
  return static_cast<std::uint32_t>(value);
}

bool YamlValue::flag() const {
  const std::string& value = scalar("true or false");
  if (value != "true" && value != "false") fail("must be true or false");
  return value == "true";
}

std::string YamlValue::text() const { return scalar("a text"); }

std::size_t YamlValue::one_of(const std::string_view* first, const std::string_view* last) const {
  const std::string_view* found = std::find(first, last, scalar("a name"));
  if (found == last) fail("\"" + node_.Scalar() + "\" is not one of the names allowed here");
  return static_cast<std::size_t>(found - first);
}

std::vector<YamlValue> YamlValue::list() const {
  if (!node_.IsSequence()) fail("must be a list");
  std::vector<YamlValue> items;
  for (const YAML::Node& item : node_)
    items.emplace_back(item, *source_, key_ + "[" + std::to_string(items.size()) + "]");
  return items;
}

YamlMap::YamlMap(const YamlValue& value) : value_(value) {
  if (!value.node_.IsMap()) value.fail("must hold keys and values");
  for (const auto& entry : value.node_) {
    const YamlValue key(entry.first, *value.source_, value.key_);
    const std::string name = key.text();
    const auto same = [&name](const Entry& other) { return other.key == name; };
    if (std::any_of(entries_.begin(), entries_.end(), same)) key.fail("the key " + name + " is given twice");
    entries_.push_back({name, entry.second});
  }
}

std::optional<YamlValue> YamlMap::take_if_present(const char* key) {
  for (Entry& entry : entries_) {
    if (entry.key != key) continue;
    entry.taken = true;
    return YamlValue(entry.value, *value_.source_, key);
  }
  return std::nullopt;
}

YamlValue YamlMap::take(const char* key) {
  std::optional<YamlValue> value = take_if_present(key);
  if (!value) value_.fail(std::string("the key ") + key + " is missing");
  return *value;
}

void YamlMap::finish() const {
  for (const Entry& entry : entries_) {
    if (!entry.taken) YamlValue(entry.value, *value_.source_, entry.key).fail("is not a key of this format");
  }
}

}  // namespace enfilade::topo_graph
