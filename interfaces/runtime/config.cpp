// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/config.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>

#include <yaml-cpp/yaml.h>

#include "interfaces/runtime/nearest.hpp"
#include "interfaces/runtime/yaml_binder.hpp"

namespace enfilade {
namespace {

std::string read_file(const std::string& file) {
  errno = 0;
  std::ifstream stream(file);
  std::ostringstream content;
  if (stream.peek() != std::ifstream::traits_type::eof()) content << stream.rdbuf();
  if (stream.is_open() && !stream.bad()) return content.str();
  const char* why = errno != 0 ? std::strerror(errno) : "it cannot be read";
  throw ConfigError(file + ": " + why + ", give a configuration file that can be read");
}

/// The file's one map, or null.
YAML::Node parse(const std::string& file) {
  std::vector<YAML::Node> documents;
  try {
    documents = YAML::LoadAll(read_file(file));
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

std::string unknown_key(const std::string& key, const std::vector<std::string>& known) {
  const auto nearest = find_nearest(key, known);
  return "there is no such key, " + (nearest ? "did you mean " + *nearest + "?" : std::string("remove it"));
}

void report_unknown(ConfigReading& reading) {
  for (const auto& [line, key] : reading.unknown) reading.at_line(line, key, unknown_key(key, reading.known));
  for (const auto& [key, value] : reading.overrides) {
    if (std::ranges::find(reading.known, key) == reading.known.end()) {
      reading.in_override(key, unknown_key(key, reading.known));
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

std::string load_config(const std::string& file, const ConfigOverrides& overrides,
                        const std::function<void(ConfigBinder&)>& bind_all) {
  const YAML::Node root = parse(file);
  ConfigReading reading;
  reading.file = file;
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
