// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "interfaces/model/counted.hpp"
#include "tools/draw/svg.hpp"
#include "tools/evaluate/maps/map_evaluation.hpp"
#include "tools/support/rectangle_json.hpp"

namespace enfilade::evaluate {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kAbout = 0.7, kRight = 0.9;
constexpr double kPixelsPerM = 16.0;
const draw::Paint kPlanWalls{.stroke = "#888", .width_px = 3.0};
const draw::Paint kTrueRoom{.stroke = "#2a2", .width_px = 1.0, .dash = "3 2"};
const draw::Paint kRightRoom{.stroke = "#16c", .width_px = 1.5};
const draw::Paint kAboutRoom{.stroke = "#e80", .width_px = 1.5};
const draw::Paint kWrongRoom{.stroke = "#d11", .width_px = 1.5};

struct Tally {
  int rooms = 0, rectangular = 0, places = 0, about = 0, right = 0;

  void add(const MapResult& result) {
    rooms += result.rooms;
    rectangular += result.rectangular;
    for (const MapPlace& place : result.places) {
      ++places;
      about += place.iou > kAbout;
      right += place.iou > kRight;
    }
  }
  std::string row(const std::string& name) const {
    const auto share = [this](int part) {
      return places > 0 ? fmt::format("{:.0f} %", 100.0 * part / places) : std::string("-");
    };
    return fmt::format("| {} | {} | {} | {} | {} | {} |\n", name, rooms, rectangular, places, share(about),
                       share(right));
  }
};

std::string title_of(const MapResult& result) {
  return result.name + (result.is_furnished ? ", furnished" : "");
}

std::string summary_of(const MapResult& result) {
  Tally tally;
  tally.add(result);
  return fmt::format("{}, {} of them rectangular; found from {} of {}", counted(tally.rooms, "room"),
                     tally.rectangular, tally.right, counted(tally.places, "place"));
}

}  // namespace

std::string to_json(const std::vector<MapResult>& results) {
  Json out = Json::array();
  for (const MapResult& result : results) {
    Json places = Json::array();
    for (const MapPlace& place : result.places)
      places.push_back({{"x_m", place.at.x()},
                        {"y_m", place.at.y()},
                        {"iou", place.iou},
                        {"truth", rectangle_json(place.truth)},
                        {"found", place.found ? rectangle_json(*place.found) : Json(nullptr)}});
    out.push_back({{"name", result.name},
                   {"furnished", result.is_furnished},
                   {"rooms", result.rooms},
                   {"rectangular", result.rectangular},
                   {"places", places}});
  }
  return out.dump(1) + "\n";
}

std::string to_markdown(const std::vector<MapResult>& results) {
  std::string out =
      "| plan | rooms | rectangular | places | IoU > 0.7 | IoU > 0.9 |\n|---|---:|---:|---:|---:|---:|\n";
  for (const bool is_furnished : {false, true}) {
    Tally all;
    for (const MapResult& result : results) {
      if (result.is_furnished != is_furnished) continue;
      Tally one;
      one.add(result);
      all.add(result);
      out += one.row(title_of(result));
    }
    out += all.row(is_furnished ? "**all, furnished**" : "**all**");
  }
  return out;
}

std::string to_svg(const MapResult& result) {
  draw::Bounds bounds;
  for (const Point2& p : result.walls) bounds.include(p);
  if (bounds.empty()) bounds.include(Point2::Zero());
  bounds.grow(0.5);
  draw::SvgCanvas canvas(bounds, kPixelsPerM);
  canvas.dots(result.walls, 1.0, kPlanWalls.stroke);
  for (const MapPlace& place : result.places) canvas.rectangle(place.truth, kTrueRoom);
  for (const MapPlace& place : result.places) {
    const draw::Paint& paint = place.iou > kRight ? kRightRoom : place.iou > kAbout ? kAboutRoom : kWrongRoom;
    if (place.found) canvas.rectangle(*place.found, paint);
    canvas.disc(place.at, 2.5, {.stroke = "", .fill = paint.stroke});
  }
  canvas.title(title_of(result), summary_of(result));
  canvas.legend({{kPlanWalls, "drawn"},
                 {kTrueRoom, "true room"},
                 {kRightRoom, fmt::format("IoU > {}", kRight)},
                 {kAboutRoom, fmt::format("IoU > {}", kAbout)},
                 {kWrongRoom, "less, or nothing"}});
  return canvas.str();
}

}  // namespace enfilade::evaluate
