// SPDX-License-Identifier: Apache-2.0
#include "tools/enfilade/report/report.hpp"

#include <cerrno>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>

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

void write_file(const std::string& path, const std::string& text) {
  const std::string temporary = path + ".part";
  std::ofstream file(temporary, std::ios::binary);
  file << text;
  file.close();
  std::error_code error(file ? 0 : errno, std::generic_category());
  if (file) std::filesystem::rename(temporary, path, error);
  if (!error) return;
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  throw std::runtime_error(fmt::format(
      "{}: cannot be written ({}): choose another place with --out or --json", path, error.message()));
}

void write_files(const Report& report, const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw std::runtime_error(
        fmt::format("{}: cannot be made ({}): choose another --out", folder, error.message()));
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

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[16] = {};
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

}  // namespace enfilade::report
