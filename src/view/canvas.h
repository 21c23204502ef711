// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "math/conventions.h"
#include "view/line_art.h"

struct _cairo;
struct _cairo_surface;

namespace parhelion {

/// sRGB components and straight alpha, each in [0, 1].
struct Colour {
  double red, green, blue, alpha = 1.0;
};

/// A rectangle in pixel coordinates, y down.
struct Box {
  Vec2 min, max;

  Vec2 size() const { return max - min; }
  Box grownBy(double margin) const { return {min - Vec2(margin), max + Vec2(margin)}; }
  bool overlaps(const Box& b) const { return min.x < b.max.x && b.min.x < max.x && min.y < b.max.y && b.min.y < max.y; }
  bool holds(const Vec2& p) const { return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y; }
  bool holds(const Box& b) const { return holds(b.min) && holds(b.max); }
};

struct Stroke {
  Colour colour;
  double width;       // pixels
  double dash = 0.0;  // length of dashes, pixels; 0: unbroken
};

/// Points in pixel coordinates joined by straight lines.
using PixelLine = std::vector<Vec2>;

/// A transparent picture to draw on, with lines and letters smoothed at their edges. Pixel coordinates are those of
/// Camera. The same calls give the same bits.
class Canvas {
 public:
  /// Throws std::invalid_argument for less than 1 or more than 32767 pixels a side, std::runtime_error where there is
  /// too little memory to draw.
  Canvas(int width, int height);

  /// Fills a rectangle.
  void rectangle(const Box& box, const Colour& colour);

  /// Draws lines in one go: where they cross they are no denser. Places must be within 1e6 pixels of the origin.
  void lines(const std::vector<PixelLine>& lines, const Stroke& stroke);

  /// Draws a circle, filled.
  void disc(const Vec2& centre, double radius, const Colour& colour);

  /// The rectangle that text of `size` (the letters' em, pixels) takes with its upper left corner at the origin: from
  /// the font's ascent to its descent, whatever the letters.
  Box textBox(std::string_view text, double size) const;

  /// Writes UTF-8 text into textBox() moved so that its upper left corner is at `place`, in `colour` with an outline in
  /// `outline`. What is not UTF-8 and control characters come out as replacement characters.
  void text(std::string_view text, const Vec2& place, double size, const Colour& colour, const Colour& outline);

  /// What has been drawn.
  LineArt lineArt() const;

 private:
  struct Release {
    void operator()(_cairo* context) const;
    void operator()(_cairo_surface* surface) const;
  };
  std::unique_ptr<_cairo_surface, Release> surface_;
  std::unique_ptr<_cairo, Release> context_;
};

}  // namespace parhelion
