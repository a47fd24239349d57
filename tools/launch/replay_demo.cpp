// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/laser3D/core/point_file.hpp"
#include "interfaces/model/counted.hpp"
#include "interfaces/runtime/command_line.hpp"
#include "interfaces/runtime/read_file.hpp"
#include "interfaces/topics/topics.hpp"
#include "tools/draw/figures.hpp"
#include "tools/launch/demo.hpp"
#include "tools/launch/progress.hpp"
#include "tools/launch/session.hpp"
#include "tools/support/files.hpp"
#include "tools/support/rectangle_json.hpp"

namespace enfilade::launch {
namespace {

using Clock = std::chrono::steady_clock;

/// What has been seen of a replay so far. It does not read the points themselves: laser3D begins when
/// somebody does, and that must be gridBuilder.
struct Replay {
  StampNs last_line_ns = 0;
  std::size_t points = 0;
  Clock::time_point last_news = Clock::now();
  RoomEstimate estimate;
  std::vector<Point2> hits;

  void listen(Bus& bus) {
    bus.subscribe<RoomEstimate>(topics::kRoomEstimate, [this](const RoomEstimate& news) {
      estimate = news;
      last_news = Clock::now();
    });
    bus.subscribe<ScanHits>(topics::kScanHits, [this](const ScanHits& line) {
      last_line_ns = line.stamp_ns;
      last_news = Clock::now();
      for (const CellHit& hit : line.hits) {
        points += hit.count;
        hits.emplace_back(hit.x_m, hit.y_m);
      }
    });
  }

  /// The scan is over when nothing has come for a while and the estimate covers the last line.
  bool over() const {
    const bool quiet = Clock::now() - last_news > std::chrono::seconds(2);
    return points > 0 && quiet && estimate.stamp_ns >= last_line_ns;
  }
};

const char* name_of(DoorState state) {
  if (state == DoorState::kOpen) return "door";
  return state == DoorState::kPossible ? "possible door" : "unseen";
}

std::string room_json(const RoomEstimate& estimate) {
  nlohmann::ordered_json room{{"id", 1}};
  room.update(rectangle_json(canonical(estimate.rectangle).rectangle));
  auto doors = nlohmann::ordered_json::array();
  for (const DoorEstimate& door : estimate.doors) {
    const Segment s = segment_of(estimate.rectangle, door.gap);
    doors.push_back({{"state", name_of(door.state)},
                     {"x_m", s.midpoint().x()},
                     {"y_m", s.midpoint().y()},
                     {"width_m", s.length()}});
  }
  return nlohmann::ordered_json{{"rooms", {room}}, {"gaps", doors}}.dump(2) + "\n";
}

void print(const RoomEstimate& estimate) {
  const Rectangle& r = estimate.rectangle;
  std::cout << fmt::format(
      "\n  room: {:.2f} × {:.2f} m, centre ({:.2f}, {:.2f}) m from the scanner, turned by {:.1f}°\n",
      r.width_m, r.height_m, r.x_m, r.y_m, rounded(degrees(r.yaw_rad), 10.0));
  for (const DoorEstimate& door : estimate.doors) {
    if (door.state == DoorState::kUnexplored) continue;
    const Point2 middle = segment_of(r, door.gap).midpoint();
    std::cout << fmt::format(
        "  {}: {:.2f} m wide, in wall {}, middle at ({:.2f}, {:.2f}) m, {:.0f} % of it seen to be free\n",
        name_of(door.state), door.gap.width_m(), door.gap.wall, middle.x(), middle.y(),
        100.0 * door.evidence.free_share);
  }
  std::cout << fmt::format("  {:.0f} % of the walls could not be seen\n",
                           100.0 * estimate.unexplored_wall_share);
}

Settings settings_of(const DemoOptions& options) {
  Settings settings = options.settings;
  settings.set("laser3D", "driver", "replay");
  settings.set("laser3D", "replay.file", std::filesystem::absolute(options.input).string());
  settings.set("gridBuilder", "stationary", "true");
  return settings;
}

}  // namespace

int run_replay_demo(const DemoOptions& options) {
  // What laser3D would refuse is refused before anything is started or written.
  laser_3d::read_points({options.input, read_file(options.input)});
  const std::string out = prepare_out_folder(options);
  const int domain = resolve_domain(options.domain, process_environment);
  Progress progress;
  Replay replay;
  Session session(
      deployment_of({"laser3D", "gridBuilder", "roomDetector"}, settings_of(options), domain, false, out),
      domain, [&progress](const std::string& text) { progress.line("enfilade     " + text); });
  replay.listen(session.bus());
  session.bus().subscribe<LogLine>(topics::kRosout, [&progress](const LogLine& line) {
    progress.line(fmt::format("{:<12} {}", line.component_name, line.text));
  });
  const SessionEnd end = session.run([&] {
    progress.status(fmt::format("{} so far", counted(replay.points, "point")));
    return replay.over();
  });
  progress.status("");
  if (end != SessionEnd::kDone) {
    print_loss(out);
    std::cerr << fmt::format("enfilade demo: {}; the logs are in {}/log\n",
                             end == SessionEnd::kInterrupted ? "interrupted" : "a component was lost", out);
    return 1;
  }
  const std::string title = std::filesystem::path(options.input).filename();
  const std::string picture = out + "/room1-scan1.svg";
  write_file(picture, draw::draw_scan({title, replay.estimate, replay.hits, Pose2{}}));
  if (!replay.estimate.found) {
    std::cerr << fmt::format("enfilade demo: no rectangle fits the {} of {}; they are drawn in {}\n",
                             counted(replay.points, "point"), options.input, picture);
    return 1;
  }
  write_file(out + "/report.json", room_json(replay.estimate));
  print(replay.estimate);
  std::cout << fmt::format("  picture, report and logs are in {}\n", out);
  return 0;
}

}  // namespace enfilade::launch
