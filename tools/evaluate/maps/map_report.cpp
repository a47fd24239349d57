// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/enfilade/draw/svg.hpp"
#include "tools/evaluate/maps/map_evaluation.hpp"

namespace enfilade::evaluate {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kAbout = 0.7, kRight = 0.9;
constexpr double kPixelsPerM = 12.0;

Json rectangle_json(const Rectangle& r) {
  return {{"x_m", r.x_m},
          {"y_m", r.y_m},
          {"yaw_rad", r.yaw_rad},
          {"width_m", r.width_m},
          {"height_m", r.height_m}};
}

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
      out += one.row(result.name + (is_furnished ? ", furnished" : ""));
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
  canvas.dots(result.walls, 1.0, "#888");
  for (const MapPlace& place : result.places) {
    canvas.rectangle(place.truth, {.stroke = "#2a2", .width_px = 1.0, .fill = "", .dash = "3 2"});
    const std::string colour = place.iou > kRight ? "#16c" : place.iou > kAbout ? "#e80" : "#d11";
    if (place.found) canvas.rectangle(*place.found, {.stroke = colour, .width_px = 1.5});
    canvas.disc(place.at, 2.5, {.stroke = "", .fill = colour});
  }
  return canvas.str();
}

}  // namespace enfilade::evaluate
