// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/common.hpp>

#include "sky/camera.h"
#include "view/canvas.h"

namespace parhelion {

/// Text and the rectangle it takes, pixel coordinates.
struct PlacedLabel {
  std::string text;
  Box box;
};

/// A place for a label, and the point that it names: a leader joins the two.
struct LabelPlace {
  Box box;
  Vec2 anchor;

  /// The leader's end at the label.
  Vec2 foot() const { return glm::clamp(anchor, box.min, box.max); }
};

/// How much is drawn where in a picture.
class Crowd {
 public:
  Crowd(int width, int height, double cell);

  /// Lines that weigh `weight` per pixel of their length.
  void add(const std::vector<PixelLine>& lines, double weight);

  /// The weighted length of lines in a rectangle, pixels, to within cells.
  double in(const Box& box) const;

 private:
  double cell_;
  int columns_, rows_;
  std::vector<double> length_;
};

/// Finds room for labels, one after the other: inside the part of the picture that shows sky, off each other, and above
/// the horizon unless they may go `below` it.
class Labels {
 public:
  Labels(const Camera& camera, const Canvas& canvas, double size, bool below = true);

  double size() const { return size_; }
  const std::vector<PlacedLabel>& placed() const { return placed_; }

  /// Keeps labels off a rectangle.
  void keepOff(const Box& box) { taken_.push_back(box); }

  /// The rectangle of a text about a centre.
  Box around(const std::string& text, const Vec2& centre) const;

  /// Rectangles of a text on all sides of a point, clear of it by `gap` pixels.
  std::vector<Box> beside(const std::string& text, const Vec2& point, double gap) const;

  /// Whether there is room for a label.
  bool fits(const Box& box) const;

  /// Puts a label in the first of the rectangles that has room; none if no rectangle has.
  std::optional<PlacedLabel> place(const std::string& text, const std::vector<Box>& candidates);

  /// The same with leaders, which keep off other labels as well.
  std::optional<LabelPlace> place(const std::string& text, const std::vector<LabelPlace>& candidates);

 private:
  const Camera& camera_;
  const Canvas& canvas_;
  bool isTaken(const Box& box) const;
  bool crossesSeam(const Box& box) const;

  double size_;  // of the letters, pixels
  bool below_;
  std::vector<Box> taken_;
  std::vector<PlacedLabel> placed_;
};

}  // namespace parhelion
