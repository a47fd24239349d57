// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

namespace enfilade::simulator {

/// Collects what is wrong with a world file.
class YamlProblems {
 public:
  explicit YamlProblems(std::string file) : file_(std::move(file)) {}

  void add(int line, const std::string& what) {
    lines_.push_back(file_ + ":" + std::to_string(line) + ": " + what);
  }
  /// Throws ConfigError if anything was added.
  void throw_if_any() const;

 private:
  std::string file_;
  std::vector<std::string> lines_;
};

/// One map of a world file, read strictly: each key once, none unknown, numbers in their range. A wrong field
/// keeps its default.
class YamlFields {
 public:
  YamlFields(const YAML::Node& node, std::string title, YamlProblems& problems);

  int line() const { return line_; }
  bool has(const std::string& key) const;

  /// The key must be there.
  double number(const std::string& key, double lowest, double highest);
  double number_or(const std::string& key, double fallback, double lowest, double highest);
  std::string text(const std::string& key);
  std::string text_or(const std::string& key, const std::string& fallback);
  bool flag_or(const std::string& key, bool fallback);
  /// Exactly `count` numbers (0: any number of them).
  std::vector<double> numbers(const std::string& key, std::size_t count, double lowest, double highest);
  /// The entries of a list of maps; empty where the key is absent.
  std::vector<YamlFields> list(const std::string& key);
  /// The raw node, for what has a form of its own.
  YAML::Node node(const std::string& key);
  std::optional<YamlFields> group(const std::string& key);

  void problem(const std::string& what) { problems_->add(line_, title_ + what); }
  void problem_at(const std::string& key, const std::string& what);
  /// Reports the keys nobody asked for. Call when all were read.
  void finish();

 private:
  YAML::Node value(const std::string& key, bool required);
  double checked(const YAML::Node& node, const std::string& key, double lowest, double highest,
                 double fallback);

  YAML::Node node_;
  std::string title_;
  YamlProblems* problems_;
  int line_ = 1;
  std::set<std::string> known_;
};

}  // namespace enfilade::simulator
