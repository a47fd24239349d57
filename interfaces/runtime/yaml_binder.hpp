// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "interfaces/runtime/config.hpp"
#include "interfaces/runtime/config_values.hpp"

namespace enfilade {

/// What is found while a configuration is read, shared by the binders of all its groups.
struct ConfigReading {
  struct Unknown {
    int line;
    std::string key;
  };
  struct Problem {
    int line;  ///< 0: not in the file
    std::string text;
  };

  void at_line(int line, const std::string& key, const std::string& what) {
    problems.push_back({line, file + ":" + std::to_string(line) + ": " + key + ": " + what});
  }
  void in_override(const std::string& key, const std::string& what) {
    problems.push_back({0, "--set " + prefix + key + ": " + what});
  }

  std::string file;
  std::string prefix;                            ///< of the overrides' keys on the command line
  std::map<std::string, std::string> overrides;  ///< by dotted key
  std::vector<Problem> problems;
  std::vector<Unknown> unknown;    ///< keys of the file that nobody asked for
  std::vector<std::string> known;  ///< dotted keys that were asked for
  std::set<std::string> groups;
  YAML::Emitter resolved;
};

/// Binds the keys of one map of the file.
class YamlBinder : public ConfigBinder {
 public:
  /// `map` may be null: all keys absent. `prefix` is "" or ends in a dot.
  YamlBinder(ConfigReading& reading, const YAML::Node& map, std::string prefix);

  void number(std::string_view key, double& value, double lowest, double highest) override;
  void integer(std::string_view key, int& value, int lowest, int highest) override;
  void flag(std::string_view key, bool& value) override;
  void text(std::string_view key, std::string& value) override;
  void group(std::string_view key, const std::function<void(ConfigBinder&)>& bind) override;

  /// After binding: the keys that are left are unknown.
  void finish();

 protected:
  std::size_t one_of(std::string_view key, std::size_t current,
                     const std::vector<std::string>& allowed) override;

 private:
  struct Entry {
    int line;
    YAML::Node value;
    bool asked_for = false;
  };

  void add_entry(const YAML::Node& key, const YAML::Node& value);
  Entry* find(const std::string& key);
  /// The dotted key, entered among the known ones.
  std::string declare(std::string_view key);
  std::optional<std::string> scalar(const std::string& name, const Entry& entry, bool may_be_quoted);
  /// Reads the key from the file, then from the overrides, by `parse(text)`.
  template <class T, class Parse>
  void read(std::string_view key, T& value, bool may_be_quoted, const Parse& parse);

  ConfigReading& reading_;
  std::string prefix_;
  std::map<std::string, Entry> entries_;
};

}  // namespace enfilade
