// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "interfaces/model/counted.hpp"
#include "tools/room/find_room.hpp"
#include "tools/support/rectangle_json.hpp"

namespace enfilade::room {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(DoorState state) {
  if (state == DoorState::kOpen) return "open";
  return state == DoorState::kPossible ? "possible" : "unexplored";
}

Json door_json(const Rectangle& rectangle, const DoorEstimate& door, int id) {
  const Segment s = segment_of(rectangle, door.gap);
  return {{"id", id},
          {"state", name_of(door.state)},
          {"wall", door.gap.wall},
          {"x_m", s.midpoint().x()},
          {"y_m", s.midpoint().y()},
          {"width_m", s.length()},
          {"height_m", door.height_m ? Json(*door.height_m) : Json(nullptr)},
          {"free_share", door.evidence.free_share},
          {"occupied_share", door.evidence.occupied_share}};
}

}  // namespace

std::string to_json(const FoundRoom& room) {
  const RoomEstimate& e = room.estimate;
  const auto number = [&e](double value) { return e.found ? Json(value) : Json(nullptr); };
  Json out{{"id", 1}};
  const Json rectangle = rectangle_json(e.rectangle);
  for (const auto& [key, value] : rectangle.items()) out[key] = number(value);
  out["doors"] = Json::array();
  out["unexplored"] = Json::array();
  out["score"] = number(e.score);
  out["unexplored_wall_share"] = number(e.unexplored_wall_share);
  int doors = 0;
  for (const DoorEstimate& door : e.doors) {
    if (door.state == DoorState::kUnexplored)
      out["unexplored"].push_back(door_json(e.rectangle, door, 0));
    else
      out["doors"].push_back(door_json(e.rectangle, door, ++doors));
  }
  for (Json& gap : out["unexplored"]) gap.erase("id");
  return out.dump(2) + "\n";
}

std::string to_text(const FoundRoom& room) {
  const RoomEstimate& e = room.estimate;
  std::string text =
      fmt::format("  robot at ({:.2f}, {:.2f}) m\n", room.T_file_robot.x_m, room.T_file_robot.y_m);
  if (!e.found) return text + "  no rectangle fits what stands around it\n";
  text += fmt::format("  room {:.2f} × {:.2f} m, centre ({:.2f}, {:.2f}) m, turned by {:.1f}°\n",
                      e.rectangle.width_m, e.rectangle.height_m, e.rectangle.x_m, e.rectangle.y_m,
                      rounded(degrees(e.rectangle.yaw_rad), 10.0));
  for (const DoorEstimate& door : e.doors) {
    if (door.state == DoorState::kUnexplored) continue;
    const Point2 middle = segment_of(e.rectangle, door.gap).midpoint();
    text += fmt::format(
        "  {} door, {:.2f} m wide{}, in wall {}, middle at ({:.2f}, {:.2f}) m, {:.0f} % of it seen free\n",
        name_of(door.state), door.gap.width_m(),
        door.height_m ? fmt::format(", {:.2f} m high", *door.height_m) : "", door.gap.wall, middle.x(),
        middle.y(), 100.0 * door.evidence.free_share);
  }
  return text + fmt::format("  {:.0f} % of the walls were not seen\n",
                            rounded(100.0 * e.unexplored_wall_share, 1.0));
}

}  // namespace enfilade::room
