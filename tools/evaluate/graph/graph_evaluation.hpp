// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "components/topoGraph/core/topo_graph.hpp"
#include "tools/evaluate/graph/synthetic_graph.hpp"

namespace enfilade::evaluate {

struct GraphEvaluationConfig {
  int seeds = 20;
  int offices = 40;
  topo_graph::GraphConfig graph;  ///< of topoGraph, for the offices
  std::string ring_world;         ///< world file of the four rooms; "" leaves that experiment out
};

/// One solver on one graph; times are of one core.
struct SolverRow {
  std::string building;
  int rooms = 0, loops = 0;
  std::string solver;
  double time_ms = 0.0;
  double cost = 0.0;   ///< ½ Σ ρ at the end
  double xi_m2 = 0.0;  ///< eq. 21, thickness taken out
  double rmse_m = 0.0;
};

/// RMSE over the seeds (√ of the mean square).
struct RmseRow {
  std::string building;
  int rooms = 0, false_doors = 0;
  double before_m = 0.0, after_m = 0.0, predicted_m = 0.0;
};

struct OfficeResult {
  int false_closures = 0, missed_rooms = 0, duplicates = 0;
  double pose_error_max_m = 0.0;
};

/// The largest error over the rooms, first room and start pose as they are in the world.
struct PoseErrors {
  double max_m = 0.0, max_rad = 0.0;
};

struct JournalResult {
  int kills = 0, lost_rooms = 0;
};

struct GraphReport {
  GraphEvaluationConfig config;
  RmseRow grid100, ring100;
  std::vector<RmseRow> rmse;
  std::vector<SolverRow> solvers;
  OfficeResult offices;
  std::optional<PoseErrors> ring4;
  std::optional<JournalResult> journal;
};

GraphReport evaluate_graph(const GraphEvaluationConfig& config);

/// The experiments by themselves.
RmseRow measure_rmse(SyntheticSpec spec, int seeds);
std::vector<SolverRow> compare_solvers();
OfficeResult explore_offices(const GraphEvaluationConfig& config);
/// The four-room ring explored by the simulated robot, odometry biased by 3 %. Nothing where it does not
/// finish.
std::optional<PoseErrors> explore_ring4(const std::string& world);
/// Kills a topoGraph at random moments and counts announced rooms that it has lost. Nothing: no such
/// experiment.
std::optional<JournalResult> kill_journal(int kills);

std::string to_json(const GraphReport& report);
std::string to_table(const GraphReport& report);
std::string to_markdown(const GraphReport& report, const std::string& date);

}  // namespace enfilade::evaluate
