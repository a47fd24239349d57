// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "components/topoGraph/core/placed_face.hpp"
#include "components/topoGraph/core/topo_state.hpp"

namespace enfilade::topo_graph {

/// The elementary changes of the graph. Ids are given in order and never twice.

RoomId insert_room(TopoState& state, Room room);

/// What became of a gap in a room's wall.
struct DoorEdit {
  DoorId door = 0;
  bool added = false;   ///< a door nobody knew
  bool joined = false;  ///< the second face of a door known from another room
};

/// Gives `room` a door at `gap`: none where it already has one there, the other face of an unresolved door of
/// another room where the two coincide (and no second one does), a new unresolved door otherwise.
DoorEdit add_door(TopoState& state, RoomId room, const WallInterval& gap, const DoorEstimate& seen,
                  const FaceMatchConfig& match);

/// Makes `door` a passage into `room` through `gap`. A door that `room` has at that place is the same one
/// seen from the other side: it is removed, and `door` takes its face.
void join_door(TopoState& state, DoorId door, RoomId room, const WallInterval& gap,
               const FaceMatchConfig& match);

/// The room other than `except` that holds the point at least `margin_m` from its walls.
std::optional<RoomId> find_room_at(const TopologicalMap& map, const Point2& p_map, RoomId except,
                                   double margin_m);

/// Takes the second face off `door` and makes an unresolved door of its own of it.
void split_door(TopoState& state, DoorId door);

Room& get_room(TopoState& state, RoomId id);
Door& get_door(TopoState& state, DoorId id);

}  // namespace enfilade::topo_graph
