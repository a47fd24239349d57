// SPDX-License-Identifier: Apache-2.0
#include "tools/launch/settings.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace enfilade {

Settings::Settings(const std::vector<std::string>& entries) {
  for (const std::string& entry : entries) {
    const std::size_t dot = entry.find('.'), equals = entry.find('=');
    if (dot == std::string::npos || equals == std::string::npos || equals < dot) {
      throw ConfigError(fmt::format("--set {}: this is no setting, write COMPONENT.KEY=VALUE", entry));
    }
    const std::string component = entry.substr(0, dot);
    if (std::find(kComponents.begin(), kComponents.end(), component) == kComponents.end()) {
      throw ConfigError(fmt::format("--set {}: there is no component '{}', choose one of {}", entry,
                                    component, fmt::join(kComponents, ", ")));
    }
    overrides_[component].push_back(entry.substr(dot + 1));
  }
}

void Settings::set(const std::string& component, const std::string& key, const std::string& value) {
  overrides_[component].push_back(key + "=" + value);
}

void Settings::set_default(const std::string& component, const std::string& key, const std::string& value) {
  const ConfigOverrides& present = of(component);
  const bool is_set = std::any_of(present.begin(), present.end(),
                                  [&](const std::string& o) { return o.starts_with(key + "="); });
  if (!is_set) set(component, key, value);
}

void Settings::refuse(const std::string& component, const std::string& key, const std::string& teller) const {
  for (const std::string& entry : of(component)) {
    if (entry.starts_with(key + "="))
      throw ConfigError(
          fmt::format("--set {}.{}: leave it out, {} tells this here", component, entry, teller));
  }
}

const ConfigOverrides& Settings::of(const std::string& component) const {
  static const ConfigOverrides kNone;
  const auto it = overrides_.find(component);
  return it == overrides_.end() ? kNone : it->second;
}

}  // namespace enfilade
