// SPDX-License-Identifier: Apache-2.0
#include "tools/report/report.hpp"

#include <fmt/format.h>

#include "tools/support/files.hpp"

namespace enfilade::report {
namespace {

std::optional<RoomId> room_of_zone(const TopologicalMap& map, std::uint32_t zone_id) {
  for (const Room& room : map.rooms) {
    if (room.zone_id == zone_id) return room.id;
  }
  return std::nullopt;
}

}  // namespace

Report make_report(const RunRecord& record, const simulator::WorldTruth& truth, const std::string& world,
                   double wall_time_s) {
  return {.world = world,
          .wall_time_s = wall_time_s,
          .record = record,
          .evaluation = evaluate(record.map, truth)};
}

void write_files(const Report& report, const std::string& folder) {
  make_folder(folder);
  write_file(folder + "/report.json", to_json(report));
  write_file(folder + "/floorplan.svg",
             draw::draw_floor_plan(report.record.map, "Recovered from the graph: " + report.world));
  for (const auto& [zone, scans] : report.record.scans) {
    const auto room = room_of_zone(report.record.map, zone);
    if (!room) continue;
    for (std::size_t i = 0; i < scans.size(); ++i) {
      draw::ScanFigure figure = scans[i];
      figure.title = fmt::format("Room {}, scan {}", *room, i + 1);
      write_file(fmt::format("{}/room{}-scan{}.svg", folder, *room, i + 1), draw::draw_scan(figure));
    }
  }
}

}  // namespace enfilade::report
