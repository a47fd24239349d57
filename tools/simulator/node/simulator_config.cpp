// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/node/simulator_config.hpp"

#include <filesystem>

namespace enfilade::simulator {

void bind(ConfigBinder& c, BodyConfig& body) {
  c.number("radius_m", body.radius_m, 0.01, 2.0);
  c.number("height_m", body.height_m, 0.01, 2.0);
  c.number("contact_height_m", body.contact_height_m, 0.01, 3.0);
}

void bind(ConfigBinder& c, DriveConfig& drive) {
  c.number("wheel_radius_m", drive.wheel_radius_m, 0.001, 1.0);
  c.number("track_m", drive.track_m, 0.01, 2.0);
  c.number("max_wheel_rad_s", drive.max_wheel_rad_s, 0.1, 1000.0);
  c.number("max_wheel_rad_s2", drive.max_wheel_rad_s2, 0.1, 10000.0);
  c.number("left_radius_scale", drive.left_radius_scale, 0.8, 1.2);
  c.number("right_radius_scale", drive.right_radius_scale, 0.8, 1.2);
  c.number("track_scale", drive.track_scale, 0.8, 1.2);
  c.number("slip_m_per_sqrt_m", drive.slip_m_per_sqrt_m, 0.0, 0.1);
  c.integer("encoder_ticks_per_turn", drive.encoder_ticks_per_turn, 0, 10000000);
}

void bind(ConfigBinder& c, RollMotorConfig& roll) {
  c.number("max_rad_s", roll.max_rad_s, 0.1, 100.0);
  c.number("max_rad_s2", roll.max_rad_s2, 0.1, 10000.0);
  c.number("end_rad", roll.end_rad, 0.1, 3.2);
  c.integer("steps_per_turn", roll.steps_per_turn, 0, 10000000);
}

void bind(ConfigBinder& c, RangeFinderConfig& laser) {
  c.number("mount_x_m", laser.mount_x_m, -2.0, 2.0);
  c.number("mount_y_m", laser.mount_y_m, -2.0, 2.0);
  c.number("mount_z_m", laser.mount_z_m, 0.0, 3.0);
  c.number("range_min_m", laser.range_min_m, 0.0, 1.0);
  c.number("range_max_m", laser.range_max_m, 1.0, 300.0);
  c.number("sigma_near_m", laser.sigma_near_m, 0.0, 1.0);
  c.number("sigma_far_m", laser.sigma_far_m, 0.0, 1.0);
  c.number("bias_m", laser.bias_m, -1.0, 1.0);
  c.number("dropout_probability", laser.dropout_probability, 0.0, 1.0);
  c.number("mixed_pixel_probability", laser.mixed_pixel_probability, 0.0, 1.0);
  c.number("mixed_pixel_min_jump_m", laser.mixed_pixel_min_jump_m, 0.0, 30.0);
  c.number("mixed_pixel_max_jump_m", laser.mixed_pixel_max_jump_m, 0.0, 30.0);
}

void bind(ConfigBinder& c, CreditPacerConfig& pacing) {
  c.number("credit_window_s", pacing.credit_window_s, 0.01, 10.0);
  c.number("credit_lifetime_s", pacing.credit_lifetime_s, 0.1, 60.0);
  c.number("wait_for_readers_s", pacing.wait_for_readers_s, 0.0, 600.0);
}

void bind(ConfigBinder& c, SimulatorConfig& config) {
  const auto group = [&c](std::string_view key, auto& part) {
    c.group(key, [&part](ConfigBinder& inner) { bind(inner, part); });
  };
  c.text("world", config.world);
  c.integer("seed", config.seed, 0, 2147483647);
  c.number("speed", config.pacing.speed, 0.0, 1000.0);
  c.number("command_timeout_s", config.simulation.command_timeout_s, 0.0, 60.0);
  c.number("ground_truth_hz", config.ground_truth_hz, 0.1, 200.0);
  group("body", config.simulation.body);
  group("drive", config.simulation.drive);
  group("roll", config.simulation.roll);
  group("laser", config.simulation.laser);
  group("pacing", config.pacing);
  group("period", config.period);
}

std::string resolve_world(const std::string& world, const std::string& config_file) {
  namespace fs = std::filesystem;
  const fs::path beside = fs::path(config_file).parent_path() / world;
  return !fs::exists(world) && fs::exists(beside) ? beside.string() : world;
}

}  // namespace enfilade::simulator
