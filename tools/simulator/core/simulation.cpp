// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/core/simulation.hpp"

#include <stdexcept>

namespace enfilade::simulator {

Simulation::Simulation(const World& world, const SimulationConfig& config)
    : truth_(world.truth),
      random_(config.seed),
      scene_(world),
      traffic_(world, config.body.radius_m, config.body.contact_height_m),
      body_(config.body, world),
      drive_(config.drive),
      roll_(config.roll),
      laser_(config.laser, config.body),
      command_timeout_ns_(from_seconds(config.command_timeout_s)) {
  sensor_.T_world_base = world.truth.T_world_start;
  if (!body_.fits(sensor_.T_world_base.translation()))
    throw std::invalid_argument("the robot does not fit at the start pose of world '" + world.name +
                                "': move the start or the furniture");
}

void Simulation::actuate(const SimActuation& actuation) {
  drive_.command(actuation.left_wheel_rad_s, actuation.right_wheel_rad_s);
  roll_.command(actuation.roll_rad_s);
  commanded_ns_ = sensor_.stamp_ns;
}

Simulation::Step Simulation::step() {
  const double dt_s = seconds(kStep_ns);
  const SensorState before = sensor_;
  if (command_timeout_ns_ > 0 && before.stamp_ns - commanded_ns_ >= command_timeout_ns_) actuate({});
  traffic_.step(dt_s, before.T_world_base.translation());
  const DriveStep motion = drive_.step(dt_s, random_);
  roll_.step(dt_s);
  sensor_ = {before.stamp_ns + kStep_ns,
             body_.move(before.T_world_base, motion.from(before.T_world_base), traffic_.outlines()),
             roll_.true_rad()};
  path_length_m_ += (sensor_.T_world_base.translation() - before.T_world_base.translation()).norm();
  if (!traffic_.empty()) scene_.place_moving(traffic_.positions());
  auto scan = laser_.sense(before, sensor_, scene_, random_);
  return {encoders(), std::move(scan)};
}

SimEncoders Simulation::encoders() const {
  return {sensor_.stamp_ns, drive_.left_rad(), drive_.right_rad(), roll_.read_rad(), roll_.speed_rad_s()};
}

GroundTruth Simulation::ground_truth() const {
  return {sensor_.stamp_ns, sensor_.T_world_base, body_.collisions(), path_length_m_};
}

}  // namespace enfilade::simulator
