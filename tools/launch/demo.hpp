// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/launch/deployment.hpp"
#include "tools/launch/settings.hpp"

namespace enfilade::launch {

struct DemoOptions {
  std::string world;  ///< "" = the paper's two rooms
  std::string input;
  double speed = 1.0;
  std::uint64_t seed = 0;
  bool seed_given = false;
  std::string out;  ///< "" = out/<time>
  std::optional<int> domain;
  Settings settings;
};

/// Simulator and six components explore a world; report, map and pictures are written. Exit status 0 only if
/// everything was explored.
int run_simulated_demo(const DemoOptions& options);

/// laser3D (replay), gridBuilder and roomDetector look at a recorded scan. Exit status 0 if a room was found.
int run_replay_demo(const DemoOptions& options);

/// The output folder, made, with its log folder, and without what an earlier run has left there. Throws
/// std::runtime_error if that cannot be.
std::string prepare_out_folder(const DemoOptions& options);

/// The processes of `components`, each with the domain, "--sim-time" where it applies, and its settings.
DeploymentConfig deployment_of(const std::vector<std::string>& components, const Settings& settings,
                               int domain, bool sim_time, const std::string& out_folder);

/// Prints why a member was lost: the last line of each log that ends in an error or a refusal.
void print_loss(const std::string& out_folder);

}  // namespace enfilade::launch
