// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "beam/triangle_cells.h"
#include "math/aligned_vector.h"
#include "math/lanes.h"

namespace parhelion {

/// Light in the pixels of a picture, added in triangles and lines. Each pixel has four sums, which a deposit adds to in
/// proportion to four numbers.
class PixelFilm {
 public:
  using Four = Lanes<4>::Real;

  PixelFilm(int width, int height)
      : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  /// Adds light at one place; none outside.
  void add(const LitPlace& at, const Four& per) {
    if (at.x >= 0.0 && at.x < width_ && at.y >= 0.0 && at.y < height_)
      addTo(static_cast<int>(at.x), static_cast<int>(at.y), at.light, per);
  }

  /// Adds the light of a triangle, across which place and density are linear. The mean of the light at its corners is
  /// all its light. It may be as thin as a line. Exact.
  void addTriangle(const LitPlace& a, const LitPlace& b, const LitPlace& c, const Four& per);

  /// The same with four corners, those of two triangles that share the edge from the second to the third: the mean of
  /// the light at all six is all its light.
  void addQuad(const LitPlace (&corner)[4], const Four& per) {
    const LitPlace &a = corner[0], &b = corner[1], &c = corner[2], &d = corner[3];
    addTriangle({a.x, a.y, 0.5 * a.light}, {b.x, b.y, 0.5 * b.light}, {c.x, c.y, 0.5 * c.light}, per);
    addTriangle({b.x, b.y, 0.5 * b.light}, {d.x, d.y, 0.5 * d.light}, {c.x, c.y, 0.5 * c.light}, per);
  }

  /// The same by points, two or three to a pixel: for light that is too faint to be put to its place exactly.
  void addFaintQuad(const LitPlace (&corner)[4], const Four& per);

  /// The same along a straight line.
  void addLine(const LitPlace& a, const LitPlace& b, const Four& per);

  const Four& at(std::size_t pixel) const { return pixels_[pixel]; }
  std::size_t pixels() const { return pixels_.size(); }

 private:
  PARHELION_INLINE void addTo(int x, int y, double light, const Four& per) {
    pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)] +=
        light * per;
  }

  int width_, height_;
  AlignedVector<Four> pixels_;
};

}  // namespace parhelion
