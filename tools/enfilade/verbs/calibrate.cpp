// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "interfaces/runtime/read_file.hpp"
#include "tools/enfilade/verbs/options.hpp"
#include "tools/enfilade/verbs/verbs.hpp"
#include "tools/evaluate/perception/range_calibration.hpp"

namespace enfilade {
namespace {

struct Arguments {
  double width_m = 0.0;
  std::string file;
  double simulated_bias_m = 0.02;
  std::uint64_t seed = 1;
};

std::optional<evaluate::RangeCalibration> calibrate(const Arguments& arguments) {
  if (arguments.file.empty())
    return evaluate::calibrate_simulated_range(arguments.width_m, arguments.simulated_bias_m, arguments.seed);
  const auto points = laser_3d::read_points({arguments.file, read_file(arguments.file)});
  return evaluate::calibrate_range(points, arguments.width_m);
}

int run(const Arguments& arguments) {
  const auto result = calibrate(arguments);
  if (!result) {
    std::cerr << fmt::format("enfilade calibrate range: no room with a side of about {:.3f} m was found\n",
                             arguments.width_m);
    return 1;
  }
  std::cout << fmt::format(
      "side: {:.4f} m measured, {:.4f} m true, {:.4f} m after the correction\n"
      "range bias: {:+.4f} m, sigma {:.4f} m\n"
      "set it with --set laser3D.projector.range_bias_m={:.4f}, or in etc/laser3D.yaml\n",
      result->measured_m, arguments.width_m, result->corrected_m, result->bias_m, result->sigma_m,
      result->bias_m);
  return 0;
}

}  // namespace

Verb add_calibrate(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* group = app.add_subcommand("calibrate", "Tell what a sensor errs by");
  CLI::App* command = group->add_subcommand(
      "range", "What the laser measures too much, from a room of which one side was measured by hand");
  command->add_option("file", arguments->file,
                      "A recorded scan (.pcd, .3d); without one, the simulated sensor in a bare room");
  command->add_option("--width", arguments->width_m, "The true length of one side of the room, m")
      ->required()
      ->check(number_in(1.5, 15.0));
  command
      ->add_option("--simulated-bias", arguments->simulated_bias_m,
                   "What the simulated sensor measures too much, m")
      ->check(number_in(-1.0, 1.0))
      ->capture_default_str();
  add_seed(*command, arguments->seed, "Seed of the simulated noise")->capture_default_str();
  const std::vector<Verb> verbs{{command, [arguments] { return run(*arguments); }}};
  return {group, [group, verbs] { return run_chosen(*group, verbs); }};
}

}  // namespace enfilade
