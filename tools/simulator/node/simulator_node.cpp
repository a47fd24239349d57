// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/node/simulator_node.hpp"

#include <stdexcept>
#include <utility>

#include "interfaces/topics/topics.hpp"
#include "tools/simulator/world/load_world.hpp"

namespace enfilade::simulator {
namespace {

Simulation make_simulation(const SimulatorConfig& config) {
  SimulationConfig simulation = config.simulation;
  simulation.seed = static_cast<std::uint64_t>(config.seed);
  const World world = load_world(config.world);
  try {
    return Simulation(world, simulation);
  } catch (const std::invalid_argument& e) {
    throw ConfigError(config.world + ": " + e.what());
  }
}

}  // namespace

SimulatorNode::SimulatorNode(const NodeContext& context, const SimulatorConfig& config)
    : SimulatorNode(context, config, std::make_unique<FollowingPacer>(context.clock)) {}

SimulatorNode::SimulatorNode(const NodeContext& context, const SimulatorConfig& config,
                             std::unique_ptr<Pacer> pacer)
    : context_(context),
      pacer_(std::move(pacer)),
      simulation_(make_simulation(config)),
      ground_truth_period_ns_(from_seconds(1.0 / config.ground_truth_hz)) {}

void SimulatorNode::initialize() {
  clock_ = context_.bus.advertise(topics::kClock);
  encoders_ = context_.bus.advertise(topics::kSimEncoders);
  scan_ = context_.bus.advertise(topics::kSimScan);
  ground_truth_ = context_.bus.advertise(topics::kGroundTruth);
  context_.bus.subscribe<SimActuation>(topics::kSimActuation,
                                       [this](const SimActuation& a) { simulation_.actuate(a); });
  context_.bus.subscribe<SimCredit>(topics::kSimCredit, [this](const SimCredit& credit) {
    pacer_->hear(credit);
    compute();
  });
}

void SimulatorNode::compute() { advance_to(pacer_->allowed_ns(simulation_.now_ns())); }

void SimulatorNode::advance_to(StampNs time_ns) {
  while (simulation_.now_ns() + Simulation::kStep_ns <= time_ns) publish_step(simulation_.step());
}

void SimulatorNode::publish_step(Simulation::Step step) {
  const StampNs now_ns = step.encoders.stamp_ns;
  clock_.publish({now_ns});
  encoders_.publish(step.encoders);
  if (step.scan) scan_.publish(std::move(*step.scan));
  if (now_ns % ground_truth_period_ns_ < Simulation::kStep_ns)
    ground_truth_.publish(simulation_.ground_truth());
}

std::unique_ptr<SimulatorNode> make_deployed_node(const NodeContext& context, const SimulatorConfig& config) {
  return std::make_unique<SimulatorNode>(context, config,
                                         std::make_unique<CreditPacer>(config.pacing, context.clock));
}

}  // namespace enfilade::simulator
