// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "components/topoGraph/storage/map_file.hpp"
#include "components/topoGraph/storage/map_names.hpp"
#include "components/topoGraph/storage/map_text.hpp"

namespace enfilade::topo_graph {

std::string to_yaml(const MapFile& file) {
  std::string out =
      "# Rooms (nodes) and doors (edges). Lengths in metres, angles in radians, times in nanoseconds.\n";
  out +=
      "# Walls count counter-clockwise from the room's +x side; from_m and to_m are measured along the "
      "wall.\n";
  out += "format: " + std::string(names::kFormat) + "\nversion: " + std::to_string(names::kVersion) + "\n";
  out += "changes: " + std::to_string(file.map.version) + "\nstamp_ns: " + std::to_string(file.map.stamp_ns) +
         "\n";
  if (file.records > 0) out += "records: " + std::to_string(file.records) + "  # of the journal, in here\n";
  out += map_text::section("rooms", file.map.rooms, map_text::room) +
         map_text::section("doors", file.map.doors, map_text::door);
  if (!file.map.links.empty()) out += map_text::section("links", file.map.links, map_text::link);
  if (!file.map.places.empty()) out += map_text::section("places", file.map.places, map_text::place);
  if (file.session) out += map_text::session(*file.session);
  return out + std::string(names::kEnd);
}

}  // namespace enfilade::topo_graph
