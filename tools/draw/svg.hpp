// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "interfaces/geometry/rectangle.hpp"

namespace enfilade::draw {

/// How a shape is painted; empty = not at all. Widths are in pixels, colours CSS.
struct Paint {
  std::string stroke;
  double width_px = 1.0;
  std::string fill;
  std::string dash;
  double opacity = 1.0;
};

struct TextStyle {
  double size_px = 12.0;
  std::string colour = "#222";
  std::string anchor = "middle";  ///< start | middle | end
  double turn_deg = 0.0;          ///< counter-clockwise, as in the world
  bool bold = false;
  bool centred = false;  ///< the point is the middle of the letters' height, not their foot
};

/// About how long `text` will be.
double text_width_px(std::string_view text, double size_px);

/// One entry of a legend.
struct Swatch {
  Paint paint;
  std::string meaning;
};

/// Bounds of a drawing in metres.
struct Bounds {
  Point2 low = Point2::Constant(1e9);
  Point2 high = Point2::Constant(-1e9);

  void include(const Point2& p);
  void include(const Rectangle& r);
  void grow(double margin_m);
  bool empty() const { return low.x() > high.x(); }
};

/// An SVG picture of a piece of the plane: x to the right, y up, metres in, pixels out. Room for a title
/// above and for a legend below is added outside the bounds.
class SvgCanvas {
 public:
  SvgCanvas(const Bounds& bounds, double pixels_per_m, double header_px = 44.0, double footer_px = 40.0);

  void line(const Point2& a, const Point2& b, const Paint& paint);
  void polygon(const std::vector<Point2>& points, const Paint& paint, bool closed = true);
  void rectangle(const Rectangle& r, const Paint& paint);
  void disc(const Point2& centre, double radius_px, const Paint& paint);
  /// Many small squares of one colour, drawn as one path.
  void dots(const std::vector<Point2>& points, double size_px, const std::string& colour,
            double opacity = 1.0);
  void text(const Point2& at, std::string_view text, const TextStyle& style, double shift_x_px = 0.0,
            double shift_y_px = 0.0);
  /// In pixels from the upper left corner of the picture.
  void label(double x_px, double y_px, std::string_view text, const TextStyle& style);
  /// What is shown, in large letters, and one more line about it.
  void title(std::string_view text, std::string_view below = "");
  /// At the lower left what the paints mean, at the lower right a bar of one metre, or of as many as can be
  /// seen.
  void legend(const std::vector<Swatch>& swatches);

  double width_px() const { return width_px_; }
  double height_px() const { return height_px_; }
  std::string str() const;

 private:
  Point2 to_px(const Point2& p) const;
  void swatch(double x_px, double y_px, const Swatch& swatch);
  int scale_bar_m() const;
  void scale_bar();

  Bounds bounds_;
  double scale_;
  double header_px_;
  double width_px_, height_px_;
  std::string body_;
};

}  // namespace enfilade::draw
