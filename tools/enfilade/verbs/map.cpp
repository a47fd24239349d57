// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>

#include "tools/enfilade/map/map_commands.hpp"
#include "tools/enfilade/verbs/options.hpp"
#include "tools/enfilade/verbs/verbs.hpp"

namespace enfilade {
namespace {

constexpr const char* kMapFile = "Map file, as topoGraph keeps it";

Verb add_show(CLI::App& group) {
  auto file = std::make_shared<std::string>();
  CLI::App* command = group.add_subcommand("show", "List rooms and doors");
  command->add_option("file", *file, kMapFile)->required();
  return {command, [file] {
            std::cout << map_tool::show(*file);
            return 0;
          }};
}

Verb add_export(CLI::App& group) {
  auto options = std::make_shared<map_tool::ExportOptions>();
  CLI::App* command = group.add_subcommand("export", "Write the map in a format of others");
  command->add_option("file", options->file, kMapFile)->required();
  command->add_option(
      "--format", options->format,
      "pgm, png (map_server, with its YAML), bt (OctoMap), svg, geojson, graphml, indoorgml; by "
      "default as --out ends, .gml being IndoorGML, .json GeoJSON, .yaml map_server");
  add_output_file(*command, "--out", options->out, "File to write")->required();
  command->add_option("--resolution", options->resolution_m, "Side of a cell, m, for pgm, png and bt")
      ->check(number_in(0.005, 5.0))
      ->capture_default_str();
  add_numbers(*command, "--rooms", options->rooms, "Only these rooms, as 1,2,5");
  return {command, [options] {
            for (const std::string& file : map_tool::export_map(*options))
              std::cout << "wrote " << file << "\n";
            return 0;
          }};
}

Verb add_map_route(CLI::App& group) {
  auto options = std::make_shared<map_tool::RouteOptions>();
  CLI::App* command = group.add_subcommand("route", "The shortest way from door to door");
  command->add_option("file", options->file, kMapFile)->required();
  command->add_option("--from", options->from, "A room's number or name, or X,Y in the map frame")
      ->required();
  command->add_option("--to", options->to, "A room's number or name, or X,Y in the map frame")->required();
  add_numbers(*command, "--closed", options->closed, "Door that cannot be used; may be repeated")
      ->allow_extra_args(false);
  return {command, [options] {
            const auto way = map_tool::route(*options);
            if (way)
              std::cout << *way;
            else
              std::cerr << "enfilade map route: no way leads from " << options->from << " to " << options->to
                        << "\n";
            return way ? 0 : 1;
          }};
}

Verb add_check(CLI::App& group) {
  auto file = std::make_shared<std::string>();
  CLI::App* command = group.add_subcommand("check", "Look for what cannot be true of a building");
  command->add_option("file", *file, kMapFile)->required();
  return {command, [file] {
            const std::vector<std::string> wrong = map_tool::check(*file);
            for (const std::string& what : wrong) std::cout << *file << ": " << what << "\n";
            if (wrong.empty()) std::cout << *file << ": nothing is wrong\n";
            return wrong.empty() ? 0 : 1;
          }};
}

Verb add_merge(CLI::App& group) {
  auto words = std::make_shared<std::vector<std::string>>(3);
  CLI::App* command = group.add_subcommand(
      "merge", "Join two maps that have rooms in common; where a robot stood is not kept");
  command->add_option("first", (*words)[0], "Map file that stays where it is")->required();
  command->add_option("second", (*words)[1], "Map file that is laid onto it")->required();
  add_output_file(*command, "--out", (*words)[2], "Map file to write")->required();
  return {command, [words] {
            std::cout << map_tool::merge((*words)[0], (*words)[1], (*words)[2]);
            return 0;
          }};
}

Verb add_restore(CLI::App& group) {
  auto file = std::make_shared<std::string>();
  CLI::App* command = group.add_subcommand("restore", "Put the last good map in place of a damaged one");
  command->add_option("file", *file, kMapFile)->required();
  return {command, [file] {
            std::cout << map_tool::restore(*file);
            return 0;
          }};
}

Verb add_rename(CLI::App& group) {
  auto words = std::make_shared<std::vector<std::string>>(3);
  CLI::App* command =
      group.add_subcommand("rename", "Give a room a name; not while a topoGraph keeps its map in the file");
  command->add_option("file", (*words)[0], kMapFile)->required();
  command->add_option("room", (*words)[1], "Its number or its name")->required();
  command->add_option("name", (*words)[2], "The new name")->required();
  return {command, [words] {
            const std::string before = map_tool::rename((*words)[0], (*words)[1], (*words)[2]);
            std::cout << "\"" << before << "\" is now called \"" << (*words)[2] << "\"\n";
            return 0;
          }};
}

Verb add_map_mark(CLI::App& group) {
  auto options = std::make_shared<map_tool::MarkOptions>();
  CLI::App* command = group.add_subcommand(
      "mark", "Note that a door is closed, or open again; not while a topoGraph keeps its map in the file");
  command->add_option("file", options->file, kMapFile)->required();
  command->add_option("door", options->door, "Its number")->required()->check(whole_number());
  add_closed_or_open(*command, options->closed);
  return {command, [options] {
            map_tool::mark(*options);
            std::cout << "door " << options->door << " is " << (options->closed ? "closed" : "open") << "\n";
            return 0;
          }};
}

}  // namespace

Verb add_map(CLI::App& app) {
  CLI::App* group = app.add_subcommand("map", "Look at a map file, check it, find ways in it, export it");
  const std::vector<Verb> verbs{add_show(*group),     add_export(*group), add_map_route(*group),
                                add_check(*group),    add_rename(*group), add_restore(*group),
                                add_map_mark(*group), add_merge(*group)};
  return {group, [group, verbs] { return run_chosen(*group, verbs); }};
}

}  // namespace enfilade
