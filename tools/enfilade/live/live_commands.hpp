// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interfaces/model/topological_map.hpp"

/// What `enfilade` asks of a system that runs. Each prints its answer and returns the exit status; wrong
/// input is told by std::exception.
namespace enfilade::live {

struct LiveRouteOptions {
  std::string from, to;  ///< a room, or "X,Y" in the map frame
  std::vector<DoorId> closed;
  std::optional<int> domain;
};
int route(const LiveRouteOptions& options);

struct LiveMarkOptions {
  DoorId door = 0;
  bool closed = false;
  std::optional<int> domain;
};
int mark(const LiveMarkOptions& options);

}  // namespace enfilade::live
