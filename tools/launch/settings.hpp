// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "interfaces/runtime/config.hpp"

namespace enfilade {

/// The processes of a simulated system, in the order in which they are best started and stopped in reverse.
inline constexpr std::array<std::string_view, 7> kComponents{
    "simulator", "motorControl", "laser3D", "gridBuilder", "roomDetector", "topoGraph", "explorer"};

/// Configuration overrides by component, from "--set COMPONENT.KEY=VALUE".
class Settings {
 public:
  Settings() = default;
  /// Throws ConfigError on an entry that names no component or has no "=".
  explicit Settings(const std::vector<std::string>& entries);

  void set(const std::string& component, const std::string& key, const std::string& value);
  /// The same, where nobody has set it.
  void set_default(const std::string& component, const std::string& key, const std::string& value);
  /// For a key that a command sets by itself: throws ConfigError where --set names it. `teller` is what tells
  /// it there, as "--world".
  void refuse(const std::string& component, const std::string& key, const std::string& teller) const;
  const ConfigOverrides& of(const std::string& component) const;

 private:
  std::map<std::string, ConfigOverrides> overrides_;
};

}  // namespace enfilade
