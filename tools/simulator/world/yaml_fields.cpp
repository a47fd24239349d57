// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/world/yaml_fields.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "interfaces/model/counted.hpp"
#include "interfaces/runtime/config.hpp"

namespace enfilade::simulator {
namespace {

constexpr std::size_t kMostTold = 8;

/// From 1; an empty document has no mark.
int line_of(const YAML::Node& node) { return std::max(node.Mark().line + 1, 1); }

std::string shown(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

}  // namespace

void YamlProblems::throw_if_any() const {
  if (lines_.empty()) return;
  std::string all;
  for (std::size_t i = 0; i < std::min(kMostTold, lines_.size()); ++i)
    all += (i == 0 ? "" : "\n") + lines_[i];
  if (lines_.size() > kMostTold)
    all += "\n… and " + counted(lines_.size() - kMostTold, "problem") + " more in this file";
  throw ConfigError(all);
}

YamlFields::YamlFields(const YAML::Node& node, std::string title, YamlProblems& problems)
    : node_(node),
      title_(title.empty() ? "" : std::move(title) + ": "),
      problems_(&problems),
      line_(line_of(node)) {
  if (!node_.IsMap()) {
    problem("a map of 'key: value' is needed here");
    node_ = YAML::Node(YAML::NodeType::Map);
    return;
  }
  std::set<std::string> seen;
  for (const auto& entry : node_)
    if (!seen.insert(entry.first.Scalar()).second)
      problems_->add(line_of(entry.first),
                     title_ + "'" + entry.first.Scalar() + "' stands here twice: keep one");
}

bool YamlFields::has(const std::string& key) const { return node_[key].IsDefined(); }

YAML::Node YamlFields::value(const std::string& key, bool required) {
  known_.insert(key);
  const YAML::Node& constant = node_;
  const YAML::Node found = constant[key];
  if (!found.IsDefined() && required) problem("'" + key + "' is missing: add it");
  return found;
}

YAML::Node YamlFields::node(const std::string& key) { return value(key, false); }

void YamlFields::problem_at(const std::string& key, const std::string& what) {
  const YAML::Node& constant = node_;
  problems_->add(has(key) ? line_of(constant[key]) : line_, title_ + what);
}

double YamlFields::checked(const YAML::Node& node, const std::string& key, double lowest, double highest,
                           double fallback) {
  double read = 0.0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, read) || !std::isfinite(read)) {
    problems_->add(line_of(node), title_ + "'" + key + "' must be a number");
    return fallback;
  }
  if (read < lowest || read > highest) {
    problems_->add(line_of(node), title_ + "'" + key + "' is " + shown(read) + ": it must lie between " +
                                      shown(lowest) + " and " + shown(highest));
    return fallback;
  }
  return read;
}

double YamlFields::number(const std::string& key, double lowest, double highest) {
  const YAML::Node found = value(key, true);
  return found.IsDefined() ? checked(found, key, lowest, highest, lowest) : lowest;
}

double YamlFields::number_or(const std::string& key, double fallback, double lowest, double highest) {
  const YAML::Node found = value(key, false);
  return found.IsDefined() ? checked(found, key, lowest, highest, fallback) : fallback;
}

std::string YamlFields::text(const std::string& key) {
  value(key, true);
  return text_or(key, "");
}

std::string YamlFields::text_or(const std::string& key, const std::string& fallback) {
  const YAML::Node found = value(key, false);
  if (!found.IsDefined()) return fallback;
  if (found.IsScalar()) return found.Scalar();
  problem_at(key, "'" + key + "' must be a text");
  return fallback;
}

bool YamlFields::flag_or(const std::string& key, bool fallback) {
  const YAML::Node found = value(key, false);
  bool read = fallback;
  if (found.IsDefined() && !(found.IsScalar() && YAML::convert<bool>::decode(found, read)))
    problem_at(key, "'" + key + "' must be true or false");
  return read;
}

std::vector<double> YamlFields::numbers(const std::string& key, std::size_t count, double lowest,
                                        double highest) {
  const YAML::Node found = value(key, true);
  if (!found.IsDefined()) return {};
  if (!found.IsSequence() || (count != 0 && found.size() != count)) {
    problem_at(key, "'" + key + "' must be a list of " + std::to_string(count) + " numbers in [ ]");
    return {};
  }
  std::vector<double> all;
  for (const YAML::Node& entry : found) all.push_back(checked(entry, key, lowest, highest, lowest));
  return all;
}

std::vector<YamlFields> YamlFields::list(const std::string& key) {
  const YAML::Node found = value(key, false);
  std::vector<YamlFields> entries;
  if (!found.IsDefined() || found.IsNull()) return entries;
  if (!found.IsSequence()) {
    problem_at(key, "'" + key + "' must be a list, each entry on a line that starts with '-'");
    return entries;
  }
  for (const YAML::Node& entry : found) entries.emplace_back(entry, key, *problems_);
  return entries;
}

std::optional<YamlFields> YamlFields::group(const std::string& key) {
  const YAML::Node found = value(key, false);
  if (!found.IsDefined()) return std::nullopt;
  return YamlFields(found, key, *problems_);
}

void YamlFields::finish() {
  for (const auto& entry : node_) {
    const std::string key = entry.first.Scalar();
    if (known_.contains(key)) continue;
    std::string allowed;
    for (const std::string& name : known_) allowed += (allowed.empty() ? "" : ", ") + name;
    problems_->add(line_of(entry.first), title_ + "'" + key + "' is not known: use one of " + allowed);
  }
}

}  // namespace enfilade::simulator
