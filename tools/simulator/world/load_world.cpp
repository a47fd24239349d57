// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/world/load_world.hpp"

#include <filesystem>

#include "interfaces/runtime/config.hpp"
#include "tools/simulator/world/readers.hpp"

namespace enfilade::simulator {
namespace {

YAML::Node parse(const std::string& file) {
  try {
    return YAML::LoadFile(file);
  } catch (const YAML::BadFile&) {
    throw ConfigError(file + ":1: the world file cannot be read: check the path");
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
    World world = read_map_server(fields, path.stem().string(), path.parent_path().string(), found);
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
