// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/world/load_world.hpp"

#include <filesystem>
#include <stdexcept>

#include "interfaces/runtime/config.hpp"
#include "interfaces/runtime/read_file.hpp"
#include "tools/simulator/world/readers.hpp"

namespace enfilade::simulator {
namespace {

std::string read_world(const std::string& file) {
  try {
    return read_file(file);
  } catch (const std::runtime_error& error) {
    throw ConfigError(error.what());
  }
}

YAML::Node parse(const std::string& file) {
  const std::string text = read_world(file);
  try {
    const YAML::Node world = YAML::Load(text);
    if (world.IsMap()) return world;
    throw ConfigError(file + ":1: is no world: write a map of 'key: value' with 'rooms' (a floor plan) or " +
                      "'image' (a map_server map)");
  } catch (const YAML::ParserException& e) {
    throw ConfigError(file + ":" + std::to_string(e.mark.line + 1) + ": not YAML (" + e.msg +
                      "): mend this line");
  }
}

}  // namespace

World load_world(const std::string& file) {
  YamlProblems found(file);
  YamlFields fields(parse(file), "", found);
  const std::filesystem::path path(file);
  if (fields.has("image")) {
    World world = read_map_server(fields, path.stem().string(), path.parent_path().string());
    found.throw_if_any();
    return world;
  }
  const FloorPlan plan = read_floor_plan(fields, path.stem().string(), found);
  found.throw_if_any();
  for (const PlanProblem& problem : problems(plan)) found.add(problem.line, problem.what);
  found.throw_if_any();
  return build_world(plan);
}

}  // namespace enfilade::simulator
