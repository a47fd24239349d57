// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "interfaces/runtime/node.hpp"
#include "tools/simulator/node/simulator_config.hpp"

namespace enfilade::simulator {

/// The world as a participant on the bus. Deployed it owns time and needs a clock of its own (wall time);
/// composed it follows the virtual clock. Only the pacer differs.
class SimulatorNode : public Node {
 public:
  /// Composed: the world follows the context's clock.
  SimulatorNode(const NodeContext& context, const SimulatorConfig& config);
  SimulatorNode(const NodeContext& context, const SimulatorConfig& config, std::unique_ptr<Pacer> pacer);

  void initialize() override;
  void compute() override;

  /// For the evaluation in a composed run.
  const WorldTruth& world_truth() const { return simulation_.world_truth(); }
  GroundTruth ground_truth() const { return simulation_.ground_truth(); }

 private:
  void advance_to(StampNs time_ns);
  void publish_step(Simulation::Step step);

  NodeContext context_;
  std::unique_ptr<Pacer> pacer_;
  Simulation simulation_;
  StampNs ground_truth_period_ns_;
  Publisher<ClockTick> clock_;
  Publisher<SimEncoders> encoders_;
  Publisher<LaserScan> scan_;
  Publisher<GroundTruth> ground_truth_;
};

/// What main gives the node: a world that owns time and waits for its readers.
std::unique_ptr<SimulatorNode> make_deployed_node(const NodeContext& context, const SimulatorConfig& config);

}  // namespace enfilade::simulator
