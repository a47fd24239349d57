// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iostream>
#include <memory>

#include "tools/enfilade/verbs/options.hpp"
#include "tools/enfilade/verbs/verbs.hpp"
#include "tools/evaluate/maps/map_evaluation.hpp"
#include "tools/support/files.hpp"

namespace enfilade {
namespace {

struct MapsArguments {
  evaluate::MapConfig config;
  std::string folder, pictures;
  ReportFiles files;
};

int run(const MapsArguments& arguments) {
  const auto results = evaluate::evaluate_maps(arguments.folder, arguments.config);
  write(arguments.files, evaluate::to_json(results), evaluate::to_markdown(results));
  if (!arguments.pictures.empty()) make_folder(arguments.pictures);
  for (const evaluate::MapResult& result : results) {
    if (arguments.pictures.empty()) break;
    const std::string name = result.name + (result.is_furnished ? "_furnished.svg" : ".svg");
    write_file((std::filesystem::path(arguments.pictures) / name).string(), evaluate::to_svg(result));
  }
  std::cout << evaluate::to_markdown(results);
  return 0;
}

}  // namespace

Verb add_evaluate_maps(CLI::App& group) {
  auto arguments = std::make_shared<MapsArguments>();
  CLI::App* command = group.add_subcommand("maps",
                                           "Rooms found in floor plans whose rooms are known: NAME.png, "
                                           "NAME_furnitures.png, NAME_gt_segmentation.png");
  command->add_option("folder", arguments->folder, "Folder of the plans")->required();
  command->add_option("--map-resolution", arguments->config.resolution_m, "Side of a pixel, m")
      ->check(number_in(0.01, 1.0))
      ->capture_default_str();
  add_report_files(*command, arguments->files);
  add_output_folder(*command, "--svg", arguments->pictures, "Draw the plans into this folder");
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace enfilade
