// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/yaml_binder.hpp"

#include <algorithm>
#include <utility>

namespace enfilade {

YamlBinder::YamlBinder(ConfigReading& reading, const YAML::Node& map, std::string prefix)
    : reading_(reading), prefix_(std::move(prefix)) {
  if (!map.IsMap()) return;
  for (const auto& entry : map) add_entry(entry.first, entry.second);
}

// yaml-cpp keeps both of two equal keys and looks up the first, so the map is taken apart here.
void YamlBinder::add_entry(const YAML::Node& key, const YAML::Node& value) {
  const int line = key.Mark().line + 1;
  if (!key.IsScalar()) {
    reading_.at_line(line, prefix_ + "?", "a list or map stands for a key, write a name");
    return;
  }
  const auto [first, is_new] = entries_.try_emplace(key.Scalar(), Entry{line, value});
  if (is_new) return;
  reading_.at_line(
      line, prefix_ + key.Scalar(),
      "is given twice, first in line " + std::to_string(first->second.line) + ", keep one of them");
}

YamlBinder::Entry* YamlBinder::find(const std::string& key) {
  const auto found = entries_.find(key);
  if (found == entries_.end()) return nullptr;
  found->second.asked_for = true;
  return &found->second;
}

std::string YamlBinder::declare(std::string_view key) {
  std::string name = prefix_ + std::string(key);
  if (std::ranges::find(reading_.known, name) != reading_.known.end())
    throw std::logic_error(name + " is bound twice");
  reading_.known.push_back(name);
  return name;
}

std::optional<std::string> YamlBinder::scalar(const std::string& name, const Entry& entry,
                                              bool may_be_quoted) {
  const YAML::Node& value = entry.value;
  if (value.IsScalar() && (may_be_quoted || value.Tag() != "!")) return value.Scalar();
  if (value.IsScalar()) {
    reading_.at_line(entry.line, name, "\"" + value.Scalar() + "\" is text, take the quotes away");
  } else if (value.IsNull()) {
    reading_.at_line(entry.line, name, "has no value, write one or remove the line");
  } else {
    reading_.at_line(entry.line, name, "is a list or map, write a single value");
  }
  return std::nullopt;
}

template <class T, class Parse>
void YamlBinder::read(std::string_view key, T& value, bool may_be_quoted, const Parse& parse) {
  const std::string name = declare(key);
  if (const Entry* entry = find(std::string(key))) {
    if (const auto text = scalar(name, *entry, may_be_quoted)) {
      const Parsed<T> parsed = parse(*text);
      if (parsed.value) value = *parsed.value;
      if (!parsed.value) reading_.at_line(entry->line, name, parsed.problem);
    }
  }
  if (const auto given = reading_.overrides.find(name); given != reading_.overrides.end()) {
    const Parsed<T> parsed = parse(given->second);
    if (parsed.value) value = *parsed.value;
    if (!parsed.value) reading_.in_override(name, parsed.problem);
  }
  reading_.resolved << YAML::Key << std::string(key) << YAML::Value;
}

void YamlBinder::number(std::string_view key, double& value, double lowest, double highest) {
  read(key, value, false, [&](const std::string& text) { return parse_number(text, lowest, highest); });
  reading_.resolved << format_number(value);
}

void YamlBinder::integer(std::string_view key, int& value, int lowest, int highest) {
  read(key, value, false, [&](const std::string& text) { return parse_integer(text, lowest, highest); });
  reading_.resolved << value;
}

void YamlBinder::flag(std::string_view key, bool& value) {
  read(key, value, false, [](const std::string& text) { return parse_flag(text); });
  reading_.resolved << value;
}

void YamlBinder::text(std::string_view key, std::string& value) {
  read(key, value, true, [](const std::string& text) { return Parsed<std::string>{text, {}}; });
  reading_.resolved << YAML::DoubleQuoted << value;
}

std::size_t YamlBinder::one_of(std::string_view key, std::size_t current,
                               const std::vector<std::string>& allowed) {
  read(key, current, true, [&](const std::string& text) { return parse_choice(text, allowed); });
  reading_.resolved << allowed.at(current);
  return current;
}

void YamlBinder::group(std::string_view key, const std::function<void(ConfigBinder&)>& bind) {
  const std::string name = declare(key);
  reading_.groups.insert(name);
  YAML::Node map;
  if (const Entry* entry = find(std::string(key))) {
    map = entry->value;
    // A group whose keys are all commented out is null.
    if (!map.IsMap() && !map.IsNull()) {
      reading_.at_line(entry->line, name, "is a group of keys, write them indented below it");
    }
  }
  if (reading_.overrides.contains(name)) reading_.in_override(name, "is a group of keys, set one of these");
  reading_.resolved << YAML::Key << std::string(key) << YAML::Value << YAML::BeginMap;
  YamlBinder binder(reading_, map, name + ".");
  bind(binder);
  binder.finish();
  reading_.resolved << YAML::EndMap;
}

void YamlBinder::finish() {
  for (const auto& [key, entry] : entries_) {
    if (!entry.asked_for) reading_.unknown.push_back({entry.line, prefix_ + key});
  }
}

}  // namespace enfilade
