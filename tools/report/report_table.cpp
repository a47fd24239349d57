// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "interfaces/model/counted.hpp"
#include "tools/report/report.hpp"

namespace enfilade::report {
namespace {

std::string size_text(const Rectangle& r) { return fmt::format("{:.2f} × {:.2f} m", r.width_m, r.height_m); }

std::string room_row(const RoomReport& room) {
  const std::string name = fmt::format("room {}", room.id);
  if (!room.truth) return fmt::format("  {:<8} {:<26} {:<26} {}\n", name, size_text(room.measured), "-", "-");
  const Rectangle& truth = *room.truth;
  const std::string error =
      fmt::format("{:+.0f}, {:+.0f} mm", rounded(1e3 * (room.measured.width_m - truth.width_m), 1.0),
                  rounded(1e3 * (room.measured.height_m - truth.height_m), 1.0));
  return fmt::format("  {:<8} {:<26} {:<26} {}\n", name, size_text(room.measured), size_text(truth), error);
}

std::string kind_text(const DoorReport& door) {
  if (door.kind == DoorKind::kPassage && door.rooms.size() > 1)
    return fmt::format("rooms {} – {}", door.rooms[0], door.rooms[1]);
  if (door.kind == DoorKind::kExit) return fmt::format("room {} – outside", door.rooms[0]);
  return fmt::format("room {} – ?", door.rooms[0]);
}

std::string door_row(const DoorReport& door) {
  const std::string measured = fmt::format("{}, {:.2f} m", kind_text(door), door.opening.length());
  std::string truth = "-", error = "-";
  if (door.truth) {
    truth = fmt::format("{:.2f} m wide", door.truth->length());
    error =
        fmt::format("width {:+.0f} mm, position {:.0f} mm",
                    rounded(1e3 * (door.opening.length() - door.truth->length()), 1.0), 1e3 * door.shift_m());
  }
  return fmt::format("  {:<8} {:<26} {:<26} {}\n", fmt::format("door {}", door.id), measured, truth, error);
}

}  // namespace

std::string to_table(const Report& report) {
  std::string out = fmt::format("\n  {:<8} {:<26} {:<26} {}\n", "", "measured", "true", "error");
  for (const RoomReport& room : report.evaluation.rooms) out += room_row(room);
  for (const DoorReport& door : report.evaluation.doors) out += door_row(door);
  const Metrics& m = report.evaluation.metrics;
  if (m.rooms_true) {
    out += fmt::format("  found {} of {} and {} of {}", m.rooms_found, counted(*m.rooms_true, "room"),
                       m.doors_found, counted(*m.doors_true, "door"));
  } else {
    out += fmt::format("  found {} and {}", counted(m.rooms_found, "room"), counted(m.doors_found, "door"));
  }
  const RunRecord& r = report.record;
  out += fmt::format(" in {:.0f} s of robot time ({:.0f} s of yours): {}, {:.1f} m driven, {}\n",
                     seconds(r.exploration.stamp_ns), report.wall_time_s, counted(r.sweeps, "sweep"),
                     r.ground_truth.path_length_m, counted(r.ground_truth.collisions, "collision"));
  return out;
}

}  // namespace enfilade::report
