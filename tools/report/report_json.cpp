// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "tools/report/report.hpp"
#include "tools/support/rectangle_json.hpp"

namespace enfilade::report {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// `exit` and `passage` say what was proven; everything else is unresolved.
const char* name_of(DoorKind kind) {
  switch (kind) {
    case DoorKind::kPassage:
      return "passage";
    case DoorKind::kExit:
      return "exit";
    case DoorKind::kUnresolved:
    case DoorKind::kBlocked:
      break;
  }
  return "unresolved";
}

Json room_json(const RoomReport& room) {
  Json out{{"id", room.id}};
  out.update(rectangle_json(room.measured));
  out["doors"] = room.doors;
  out["truth"] = room.truth ? rectangle_json(*room.truth) : Json(nullptr);
  return out;
}

Json door_json(const DoorReport& door) {
  Json out{{"id", door.id}, {"kind", name_of(door.kind)}};
  out["rooms"] =
      Json::array({door.rooms.front(), door.rooms.size() > 1 ? Json(door.rooms[1]) : Json(nullptr)});
  out["x_m"] = door.opening.midpoint().x();
  out["y_m"] = door.opening.midpoint().y();
  out["width_m"] = door.opening.length();
  if (door.truth) {
    const Point2 middle = door.truth->midpoint();
    out["truth"] = {{"x_m", middle.x()}, {"y_m", middle.y()}, {"width_m", door.truth->length()}};
  } else {
    out["truth"] = nullptr;
  }
  return out;
}

Json metrics_json(const Metrics& m, double pose_error_max_m) {
  return {{"rooms_true", or_null(m.rooms_true)},
          {"rooms_found", m.rooms_found},
          {"room_precision", or_null(m.room_precision)},
          {"room_recall", or_null(m.room_recall)},
          {"room_iou_mean", or_null(m.room_iou_mean)},
          {"size_error_mean_m", or_null(m.size_error_mean_m)},
          {"size_error_max_m", or_null(m.size_error_max_m)},
          {"center_error_mean_m", or_null(m.center_error_mean_m)},
          {"doors_true", or_null(m.doors_true)},
          {"doors_found", m.doors_found},
          {"door_precision", or_null(m.door_precision)},
          {"door_recall", or_null(m.door_recall)},
          {"door_error_mean_m", or_null(m.door_error_mean_m)},
          {"pose_error_max_m", pose_error_max_m}};
}

}  // namespace

std::string to_json(const Report& report) {
  const RunRecord& record = report.record;
  Json out{{"world", report.world},
           {"finished", record.finished()},
           {"sim_time_s", seconds(record.exploration.stamp_ns)},
           {"wall_time_s", report.wall_time_s},
           {"path_length_m", record.ground_truth.path_length_m},
           {"collisions", record.ground_truth.collisions},
           {"sweeps", record.sweeps},
           {"rooms", Json::array()},
           {"doors", Json::array()}};
  for (const RoomReport& room : report.evaluation.rooms) out["rooms"].push_back(room_json(room));
  for (const DoorReport& door : report.evaluation.doors) out["doors"].push_back(door_json(door));
  out["metrics"] = metrics_json(report.evaluation.metrics, record.pose_error_max_m);
  return out.dump(2) + "\n";
}

}  // namespace enfilade::report
