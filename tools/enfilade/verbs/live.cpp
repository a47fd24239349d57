// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "tools/enfilade/live/live_commands.hpp"
#include "tools/enfilade/verbs/options.hpp"
#include "tools/enfilade/verbs/verbs.hpp"

namespace enfilade {

Verb add_route(CLI::App& app) {
  auto options = std::make_shared<live::LiveRouteOptions>();
  CLI::App* command =
      app.add_subcommand("route", "Ask the running topoGraph for the shortest way from door to door");
  command->add_option("from", options->from, "A room's number or name, or X,Y in the map frame")->required();
  command->add_option("to", options->to, "A room's number or name, or X,Y in the map frame")->required();
  add_numbers(*command, "--closed", options->closed, "Door that cannot be used; may be repeated")
      ->allow_extra_args(false);
  add_domain(*command, options->domain);
  return {command, [options] { return live::route(*options); }};
}

Verb add_mark(CLI::App& app) {
  auto options = std::make_shared<live::LiveMarkOptions>();
  CLI::App* command =
      app.add_subcommand("mark", "Tell the running topoGraph that a door is closed, or open again");
  command->add_option("door", options->door, "Its number")->required()->check(whole_number());
  add_closed_or_open(*command, options->closed);
  add_domain(*command, options->domain);
  return {command, [options] { return live::mark(*options); }};
}

void add_closed_or_open(CLI::App& command, bool& closed) {
  command
      .add_option_function<std::string>(
          "state", [&closed](const std::string& s) { closed = s == "closed"; }, "closed or open")
      ->required()
      ->check(CLI::IsMember({"closed", "open"}));
}

}  // namespace enfilade
