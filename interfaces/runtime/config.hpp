// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace enfilade {

/// A configuration that cannot be used. `what()` holds one line per problem: "file:line: key: what is wrong,
/// what to do".
class ConfigError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// "KEY=VALUE" from the command line; KEY is dotted for groups ("period.compute_s").
using ConfigOverrides = std::vector<std::string>;

/// Binds the keys of one YAML map to the fields of a Config struct. The struct holds the defaults; a key that
/// is absent leaves its field alone. Unknown, duplicate, ill-typed and out-of-range keys are collected and
/// reported together by load_config().
class ConfigBinder {
 public:
  virtual ~ConfigBinder() = default;
  /// Closed range, in the unit the key's suffix names.
  virtual void number(std::string_view key, double& value, double lowest, double highest) = 0;
  virtual void integer(std::string_view key, int& value, int lowest, int highest) = 0;
  virtual void flag(std::string_view key, bool& value) = 0;
  virtual void text(std::string_view key, std::string& value) = 0;
  /// A nested map.
  virtual void group(std::string_view key, const std::function<void(ConfigBinder&)>& bind) = 0;

  /// One of a set of names.
  template <class Enum>
  void choice(std::string_view key, Enum& value,
              std::initializer_list<std::pair<std::string_view, Enum>> names) {
    std::vector<std::string> allowed;
    std::size_t index = 0;
    for (const auto& [name, meaning] : names) {
      if (meaning == value) index = allowed.size();
      allowed.emplace_back(name);
    }
    index = one_of(key, index, allowed);
    value = (names.begin() + index)->second;
  }

 protected:
  /// Index of the chosen name; `current` where the key is absent or wrong.
  virtual std::size_t one_of(std::string_view key, std::size_t current,
                             const std::vector<std::string>& allowed) = 0;
};

/// How often the life cycle calls the node.
struct PeriodConfig {
  double compute_s = 0.1;
  double emergency_s = 0.5;
};

inline void bind(ConfigBinder& c, PeriodConfig& period) {
  c.number("compute_s", period.compute_s, 0.001, 10.0);
  c.number("emergency_s", period.emergency_s, 0.01, 60.0);
}

/// Reads `file` (YAML) into a binder that `bind_all` fills fields through, applies `overrides`, and throws
/// ConfigError naming every problem at once. Returns the resolved configuration as YAML text, for the log.
/// `prefix` is what stood before each override's key on the command line ("roomDetector."), for the errors.
std::string load_config(const std::string& file, const ConfigOverrides& overrides, const std::string& prefix,
                        const std::function<void(ConfigBinder&)>& bind_all);

/// Every component declares `struct XConfig` with a member `PeriodConfig period` and a free function
/// `bind(ConfigBinder&, XConfig&)`.
template <class Config>
Config load_config(const std::string& file, const ConfigOverrides& overrides = {},
                   std::string* resolved = nullptr, const std::string& prefix = "") {
  Config config;
  const std::string text =
      load_config(file, overrides, prefix, [&config](ConfigBinder& c) { bind(c, config); });
  if (resolved) *resolved = text;
  return config;
}

}  // namespace enfilade
