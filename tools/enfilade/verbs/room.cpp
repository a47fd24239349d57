// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "components/gridBuilder/node/grid_builder_config.hpp"
#include "components/laser3D/node/laser_3d_config.hpp"
#include "components/roomDetector/node/room_detector_config.hpp"
#include "tools/enfilade/verbs/options.hpp"
#include "tools/enfilade/verbs/verbs.hpp"
#include "tools/launch/component_config.hpp"
#include "tools/launch/composed_run.hpp"
#include "tools/room/find_room.hpp"
#include "tools/support/files.hpp"

namespace enfilade {
namespace {

struct RoomArguments {
  std::string file, json, svg;
  std::vector<double> at;
  std::vector<std::string> settings;
  double map_resolution_m = 0.05;
};

int run(const RoomArguments& arguments) {
  const Settings settings(arguments.settings);
  check_settings(settings);
  const auto detector =
      load_component_config<room_detector::RoomDetectorNodeConfig>("roomDetector", settings).detector;
  const room::SurveyConfig config{
      .cloud = load_component_config<laser_3d::Laser3DConfig>("laser3D", settings).replay.cloud,
      .grid = load_component_config<grid_builder::GridBuilderConfig>("gridBuilder", settings).grid,
      .map_resolution_m = arguments.map_resolution_m};
  const auto at =
      arguments.at.empty() ? std::nullopt : std::optional(Point2(arguments.at[0], arguments.at[1]));
  const room::FoundRoom found = room::find_room(room::read_survey(arguments.file, config), detector, at);
  if (!arguments.json.empty()) write_file(arguments.json, room::to_json(found));
  if (!arguments.svg.empty())
    write_file(arguments.svg, room::to_svg(found, std::filesystem::path(arguments.file).filename()));
  std::cout << room::to_text(found);
  return found.estimate.found ? 0 : 1;
}

}  // namespace

Verb add_room(CLI::App& app) {
  auto arguments = std::make_shared<RoomArguments>();
  CLI::App* command =
      app.add_subcommand("room",
                         "Find the room around a point of a recorded building: a 3D scan, an OctoMap, a "
                         "robot's log or a map image");
  command
      ->add_option("file", arguments->file,
                   ".bt (OctoMap), .pcd, .3d (3DTK), .clf or .log (CARMEN), .yaml (map_server), .png or .pgm")
      ->required();
  command
      ->add_option(
          "--at", arguments->at,
          "X,Y in the file's own coordinates, m: where the robot stands. By default where the scanner "
          "stood (scans), where the robot ended (logs), or where most space is free (maps)")
      ->delimiter(',')
      ->expected(2)
      ->check(number_in(-1e6, 1e6));
  add_output_file(*command, "--json", arguments->json, "Write the room to this file");
  add_output_file(*command, "--svg", arguments->svg, "Draw the room into this file");
  command
      ->add_option("--map-resolution", arguments->map_resolution_m,
                   "Side of a pixel, m, of an image given without its YAML")
      ->check(number_in(0.01, 1.0))
      ->capture_default_str();
  add_settings(*command, arguments->settings);
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace enfilade
