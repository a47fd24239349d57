// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/config.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <yaml-cpp/yaml.h>

#include "interfaces/runtime/nearest.hpp"
#include "interfaces/runtime/read_file.hpp"
#include "interfaces/runtime/yaml_binder.hpp"

namespace enfilade {
namespace {

std::string read_configuration(const std::string& file) {
  try {
    return read_file(file);
  } catch (const std::runtime_error& error) {
    throw ConfigError(error.what());
  }
}

/// The file's one map, or null.
YAML::Node parse(const std::string& file) {
  std::vector<YAML::Node> documents;
  try {
    documents = YAML::LoadAll(read_configuration(file));
  } catch (const YAML::Exception& e) {
    throw ConfigError(file + ":" + std::to_string(e.mark.line + 1) + ": this is not YAML (" + e.msg +
                      "), mend the line");
  }
  if (documents.empty()) return {};
  if (documents.size() > 1)
    throw ConfigError(file + ":1: there are several YAML documents in the file, keep one");
  const YAML::Node& root = documents.front();
  if (root.IsMap() || root.IsNull()) return root;
  throw ConfigError(file + ":" + std::to_string(root.Mark().line + 1) +
                    ": the file is not a map, write lines of the form \"key: value\"");
}

/// The last of several values for a key counts.
void add_override(const std::string& text, ConfigReading& reading) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    reading.in_override(text, "this is no setting, write KEY=VALUE");
  } else {
    reading.overrides[text.substr(0, equals)] = text.substr(equals + 1);
  }
}

std::string unknown_key(const std::string& key, const ConfigReading& reading, const std::string& prefix,
                        const std::string& otherwise) {
  const auto nearest = find_nearest(key, reading.known);
  return "there is no such key, " + (nearest ? "did you mean " + prefix + *nearest + "?" : otherwise);
}

void report_unknown(ConfigReading& reading) {
  for (const auto& [line, key] : reading.unknown)
    reading.at_line(line, key, unknown_key(key, reading, "", "remove it"));
  for (const auto& [key, value] : reading.overrides) {
    if (std::ranges::find(reading.known, key) == reading.known.end()) {
      reading.in_override(
          key, unknown_key(key, reading, reading.prefix, "choose one of those in " + reading.file));
    }
  }
}

void throw_if_wrong(ConfigReading& reading) {
  if (reading.problems.empty()) return;
  std::ranges::stable_sort(reading.problems, {}, [](const auto& problem) {
    return problem.line == 0 ? std::numeric_limits<int>::max() : problem.line;
  });
  std::string text;
  for (const auto& problem : reading.problems) text += (text.empty() ? "" : "\n") + problem.text;
  throw ConfigError(text);
}

}  // namespace

std::string load_config(const std::string& file, const ConfigOverrides& overrides, const std::string& prefix,
                        const std::function<void(ConfigBinder&)>& bind_all) {
  const YAML::Node root = parse(file);
  ConfigReading reading;
  reading.file = file;
  reading.prefix = prefix;
  for (const std::string& text : overrides) add_override(text, reading);
  reading.resolved << YAML::BeginMap;
  YamlBinder binder(reading, root, "");
  bind_all(binder);
  binder.finish();
  reading.resolved << YAML::EndMap;
  report_unknown(reading);
  throw_if_wrong(reading);
  return std::string(reading.resolved.c_str()) + "\n";
}

}  // namespace enfilade
