// SPDX-License-Identifier: Apache-2.0
#include "view/picture_lines.h"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "sky/picture_parts.h"

namespace parhelion {
namespace {

// A chord may miss the middle of its arc by this much, pixels.
constexpr double kFlatness = 0.1;

// Halvings of a line's steps, down to 4e-9 rad: what is then still not straight is torn apart.
constexpr int kHalvings = 20;

class Plotter {
 public:
  Plotter(const Camera& camera, const Box& frame) : camera_(camera), frame_(frame) {}

  std::vector<PixelLine> plot(const SkyLine& line) {
    for (std::size_t i = 1; i < line.size(); ++i)
      step({line[i - 1], camera_.placeOf(line[i - 1])}, {line[i], camera_.placeOf(line[i])}, kHalvings);
    return std::move(lines_);
  }

 private:
  struct Point {
    Vec3 toSky;
    std::optional<Vec2> place;
  };

  void step(const Point& a, const Point& b, int halvings) {
    const Vec3 middle = glm::normalize(a.toSky + b.toSky);
    const Point m{middle, camera_.placeOf(middle)};
    if (!a.place && !m.place && !b.place) return;
    if (a.place && m.place && b.place) {
      if (isFarOff(*a.place, *m.place, *b.place)) return;
      if (glm::length(*m.place - 0.5 * (*a.place + *b.place)) < kFlatness) return join(*a.place, *b.place);
    }
    if (halvings == 0) return;
    step(a, m, halvings - 1);
    step(m, b, halvings - 1);
  }

  /// Whether an arc keeps clear of the frame; it is given as much room beside its points as they take themselves.
  bool isFarOff(const Vec2& a, const Vec2& m, const Vec2& b) const {
    const Box box{glm::min(a, glm::min(m, b)), glm::max(a, glm::max(m, b))};
    return !box.grownBy(std::max(box.size().x, box.size().y) + kFlatness).overlaps(frame_);
  }

  /// Adds what the frame leaves of a straight piece. Liang & Barsky 1984.
  void join(const Vec2& a, const Vec2& b) {
    double from = 0.0, to = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
      const double d = b[axis] - a[axis], low = frame_.min[axis] - a[axis], high = frame_.max[axis] - a[axis];
      if (d == 0.0 && (low > 0.0 || high < 0.0)) return;
      if (d == 0.0) continue;
      from = std::max(from, std::min(low / d, high / d));
      to = std::min(to, std::max(low / d, high / d));
    }
    if (from >= to) return;
    const Vec2 begin = from == 0.0 ? a : a + from * (b - a), end = to == 1.0 ? b : a + to * (b - a);
    if (lines_.empty() || lines_.back().back() != begin) lines_.push_back({begin});
    lines_.back().push_back(end);
  }

  const Camera& camera_;
  Box frame_;
  std::vector<PixelLine> lines_;
};

}  // namespace

std::vector<PixelLine> linesInPicture(const Camera& camera, const SkyLine& line, const Box& frame) {
  const std::vector<PicturePart> parts = partsOf(camera.settings());
  if (parts.size() == 1) return Plotter(camera, frame).plot(line);
  std::vector<PixelLine> all;
  for (const PicturePart& part : parts) {
    const Vec2 corner(part.left, 0.0);
    const Camera half(part.camera);
    for (PixelLine& shown : Plotter(half, {frame.min - corner, frame.max - corner}).plot(line)) {
      for (Vec2& place : shown) place += corner;
      all.push_back(std::move(shown));
    }
  }
  return all;
}

}  // namespace parhelion
