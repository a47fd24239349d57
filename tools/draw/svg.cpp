// SPDX-License-Identifier: Apache-2.0
#include "tools/draw/svg.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace enfilade::draw {
namespace {

constexpr double kMargin_px = 12.0;
constexpr double kSwatch_px = 18.0;
constexpr double kLegend_px = 11.0;
constexpr double kRow_px = 16.0;
constexpr double kShortestBar_px = 50.0;
constexpr std::array kBars_m{1, 2, 5, 10, 20, 50, 100};

std::string attributes(const Paint& paint) {
  std::string out = fmt::format(R"(fill="{}")", paint.fill.empty() ? "none" : paint.fill);
  if (!paint.stroke.empty())
    out += fmt::format(R"( stroke="{}" stroke-width="{:.4g}")", paint.stroke, paint.width_px);
  if (!paint.dash.empty()) out += fmt::format(R"( stroke-dasharray="{}")", paint.dash);
  if (paint.opacity < 1.0) out += fmt::format(R"( opacity="{:.3g}")", paint.opacity);
  return out;
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else
      out += c;
  }
  return out;
}

std::string text_element(const Point2& px, std::string_view text, const TextStyle& style) {
  const std::string turn =
      style.turn_deg != 0.0
          ? fmt::format(R"svg( transform="rotate({:.3f} {:.2f} {:.2f})")svg", -style.turn_deg, px.x(), px.y())
          : "";
  return fmt::format(
      R"(<text x="{:.2f}" y="{:.2f}" font-size="{:.3g}" fill="{}" text-anchor="{}"{}{}{}>{}</text>)"
      "\n",
      px.x(), px.y(), style.size_px, style.colour, style.anchor, style.bold ? R"( font-weight="bold")" : "",
      style.centred ? R"( dy="0.35em")" : "", turn, escaped(text));
}

}  // namespace

double text_width_px(std::string_view text, double size_px) {
  const auto letters = std::ranges::count_if(text, [](unsigned char c) { return (c & 0xC0) != 0x80; });
  return 0.62 * size_px * static_cast<double>(letters);
}

void Bounds::include(const Point2& p) {
  low = low.cwiseMin(p);
  high = high.cwiseMax(p);
}

void Bounds::include(const Rectangle& r) {
  for (const Point2& corner : r.corners()) include(corner);
}

void Bounds::grow(double margin_m) {
  low.array() -= margin_m;
  high.array() += margin_m;
}

SvgCanvas::SvgCanvas(const Bounds& bounds, double pixels_per_m, double header_px, double footer_px)
    : bounds_(bounds), scale_(pixels_per_m), header_px_(header_px) {
  width_px_ = std::max(320.0, (bounds.high.x() - bounds.low.x()) * scale_);
  height_px_ = (bounds.high.y() - bounds.low.y()) * scale_ + header_px + footer_px;
}

Point2 SvgCanvas::to_px(const Point2& p) const {
  const double slack = 0.5 * (width_px_ - (bounds_.high.x() - bounds_.low.x()) * scale_);
  return {slack + (p.x() - bounds_.low.x()) * scale_, header_px_ + (bounds_.high.y() - p.y()) * scale_};
}

void SvgCanvas::line(const Point2& a, const Point2& b, const Paint& paint) { polygon({a, b}, paint, false); }

void SvgCanvas::polygon(const std::vector<Point2>& points, const Paint& paint, bool closed) {
  std::string path;
  for (const Point2& point : points) {
    const Point2 px = to_px(point);
    path += fmt::format("{}{:.2f} {:.2f}", path.empty() ? "M" : "L", px.x(), px.y());
  }
  body_ += fmt::format("<path d=\"{}{}\" {}/>\n", path, closed ? "Z" : "", attributes(paint));
}

void SvgCanvas::rectangle(const Rectangle& r, const Paint& paint) {
  const auto corners = r.corners();
  polygon({corners.begin(), corners.end()}, paint);
}

void SvgCanvas::disc(const Point2& centre, double radius_px, const Paint& paint) {
  const Point2 px = to_px(centre);
  body_ += fmt::format(R"(<circle cx="{:.2f}" cy="{:.2f}" r="{:.4g}" {}/>)"
                       "\n",
                       px.x(), px.y(), radius_px, attributes(paint));
}

void SvgCanvas::dots(const std::vector<Point2>& points, double size_px, const std::string& colour,
                     double opacity) {
  if (points.empty()) return;
  std::string path;
  for (const Point2& point : points) {
    const Point2 px = to_px(point);
    path += fmt::format("M{:.1f} {:.1f}h{:.2g}", px.x() - 0.5 * size_px, px.y(), size_px);
  }
  body_ += fmt::format(R"(<path d="{}" stroke="{}" stroke-width="{:.3g}" opacity="{:.3g}" fill="none"/>)"
                       "\n",
                       path, colour, size_px, opacity);
}

void SvgCanvas::text(const Point2& at, std::string_view text, const TextStyle& style, double shift_x_px,
                     double shift_y_px) {
  body_ += text_element(to_px(at) + Point2(shift_x_px, shift_y_px), text, style);
}

void SvgCanvas::label(double x_px, double y_px, std::string_view text, const TextStyle& style) {
  body_ += text_element({x_px, y_px}, text, style);
}

void SvgCanvas::title(std::string_view text, std::string_view below) {
  label(kMargin_px, 20.0, text, {.size_px = 14.0, .anchor = "start", .bold = true});
  if (!below.empty()) label(kMargin_px, 37.0, below, {.size_px = 12.0, .anchor = "start"});
}

void SvgCanvas::swatch(double x_px, double y_px, const Swatch& swatch) {
  body_ += fmt::format(R"(<path d="M{:.1f} {:.1f}h{:.0f}" {}/>)"
                       "\n",
                       x_px, y_px, kSwatch_px, attributes(swatch.paint));
  label(x_px + kSwatch_px + 6.0, y_px + 4.0, swatch.meaning, {.size_px = kLegend_px, .anchor = "start"});
}

void SvgCanvas::legend(const std::vector<Swatch>& swatches) {
  const double end = width_px_ - scale_bar_m() * scale_ - 2.0 * kMargin_px;
  std::vector<std::pair<double, int>> places;  // x and row
  double x = kMargin_px;
  int row = 0;
  for (const Swatch& swatch : swatches) {
    const double length = kSwatch_px + 6.0 + text_width_px(swatch.meaning, kLegend_px);
    if (x > kMargin_px && x + length > end) {
      x = kMargin_px;
      ++row;
    }
    places.emplace_back(x, row);
    x += length + kMargin_px;
  }
  height_px_ += kRow_px * row;
  for (std::size_t i = 0; i < swatches.size(); ++i)
    swatch(places[i].first, height_px_ - 14.0 - kRow_px * (row - places[i].second), swatches[i]);
  scale_bar();
}

int SvgCanvas::scale_bar_m() const {
  const auto can_be_seen = [this](int metres) { return metres * scale_ >= kShortestBar_px; };
  const auto shortest = std::ranges::find_if(kBars_m, can_be_seen);
  return shortest == kBars_m.end() ? kBars_m.back() : *shortest;
}

void SvgCanvas::scale_bar() {
  const double length = scale_bar_m() * scale_, y = height_px_ - 16.0, x = width_px_ - kMargin_px - length;
  body_ +=
      fmt::format(R"(<path d="M{0:.1f} {1:.1f}v6h{2:.1f}v-6" fill="none" stroke="#222" stroke-width="1.2"/>)"
                  "\n",
                  x, y, length);
  label(x + 0.5 * length, y, fmt::format("{} m", scale_bar_m()), {.size_px = kLegend_px});
}

std::string SvgCanvas::str() const {
  return fmt::format(
      R"(<?xml version="1.0" encoding="UTF-8"?>)"
      "\n"
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0:.0f}" height="{1:.0f}" viewBox="0 0 {0:.0f} {1:.0f}")"
      R"( font-family="DejaVu Sans, Helvetica, Arial, sans-serif">)"
      "\n"
      R"(<rect width="{0:.0f}" height="{1:.0f}" fill="#ffffff"/>)"
      "\n{2}</svg>\n",
      width_px_, height_px_, body_);
}

}  // namespace enfilade::draw
