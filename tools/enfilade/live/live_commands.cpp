// SPDX-License-Identifier: Apache-2.0
#include "tools/enfilade/live/live_commands.hpp"

#include <iostream>

#include <fmt/format.h>

#include "interfaces/runtime/command_line.hpp"
#include "interfaces/topics/topics.hpp"
#include "tools/enfilade/live/live_system.hpp"
#include "tools/enfilade/map/map_commands.hpp"

namespace enfilade::live {
namespace {

int nobody_answers(const char* verb, int domain) {
  std::cerr << fmt::format(
      "enfilade {}: no topoGraph answers in DDS domain {}: start one, or give its --domain\n", verb, domain);
  return 1;
}

}  // namespace

int route(const LiveRouteOptions& options) {
  const int domain = resolve_domain(options.domain, process_environment);
  LiveSystem system(domain);
  const auto map = system.newest(topics::kTopologicalMap);
  if (!map) return nobody_answers("route", domain);
  const RouteRequest request{.call = {},
                             .start = map_tool::parse_place(*map, "the running map", options.from),
                             .goal = map_tool::parse_place(*map, "the running map", options.to),
                             .closed_doors = options.closed};
  const auto reply = system.ask(topics::kRoute, request);
  if (!reply) return nobody_answers("route", domain);
  if (!reply->found) {
    std::cerr << "enfilade route: " << reply->message << "\n";
    return 1;
  }
  std::cout << map_tool::describe(*map, reply->route);
  return 0;
}

int mark(const LiveMarkOptions& options) {
  const int domain = resolve_domain(options.domain, process_environment);
  LiveSystem system(domain);
  const auto reply =
      system.ask(topics::kMarkDoor,
                 MarkDoorRequest{.call = {}, .door = options.door, .kind = {}, .closed = options.closed});
  if (!reply) return nobody_answers("mark", domain);
  if (!reply->accepted) {
    std::cerr << "enfilade mark: " << reply->message << "\n";
    return 1;
  }
  std::cout << fmt::format("door {} is {}\n", options.door, options.closed ? "closed" : "open");
  return 0;
}

}  // namespace enfilade::live
