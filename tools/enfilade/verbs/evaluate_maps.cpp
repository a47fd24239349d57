// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iostream>
#include <memory>

#include "tools/enfilade/report/report.hpp"
#include "tools/enfilade/verbs/verbs.hpp"
#include "tools/evaluate/maps/map_evaluation.hpp"

namespace enfilade {
namespace {

struct MapsArguments {
  evaluate::MapConfig config;
  std::string folder, json, markdown, pictures;
};

int run(const MapsArguments& arguments) {
  const auto results = evaluate::evaluate_maps(arguments.folder, arguments.config);
  if (!arguments.json.empty()) report::write_file(arguments.json, evaluate::to_json(results));
  if (!arguments.markdown.empty()) report::write_file(arguments.markdown, evaluate::to_markdown(results));
  if (!arguments.pictures.empty()) std::filesystem::create_directories(arguments.pictures);
  for (const evaluate::MapResult& result : results) {
    if (arguments.pictures.empty()) break;
    const std::string name = result.name + (result.is_furnished ? "_furnished.svg" : ".svg");
    report::write_file((std::filesystem::path(arguments.pictures) / name).string(), evaluate::to_svg(result));
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
      ->check(CLI::Range(0.01, 1.0));
  command->add_option("--json", arguments->json, "Write every place to this file");
  command->add_option("--markdown", arguments->markdown, "Write the table to this file");
  command->add_option("--svg", arguments->pictures, "Draw the plans into this folder");
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace enfilade
