// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "components/roomDetector/core/room_detector.hpp"
#include "tools/room/survey.hpp"

namespace enfilade::room {

/// The room around a place, in the coordinates of the file.
struct FoundRoom {
  RoomEstimate estimate;       ///< yaw in [-π/4, π/4)
  Pose2 T_file_robot;          ///< the place
  std::vector<Point2> points;  ///< centres of the columns in which something stands, for the picture
};

/// What roomDetector says of `survey` when the robot stands at `at`, or where the survey suggests.
FoundRoom find_room(const Survey& survey, const room_detector::RoomDetectorConfig& config,
                    const std::optional<Point2>& at);

/// The configuration for a grid of one layer: that layer alone tells of walls and doors.
room_detector::RoomDetectorConfig planar(room_detector::RoomDetectorConfig config, double resolution_m);

/// One element of `rooms` of a report, with the doors of this room; numbers are null where no room was found.
std::string to_json(const FoundRoom& room);
std::string to_text(const FoundRoom& room);
/// Walls, rectangle and doors over what stands there.
std::string to_svg(const FoundRoom& room, const std::string& title);

}  // namespace enfilade::room
