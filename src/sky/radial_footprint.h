// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "math/conventions.h"
#include "sky/camera.h"
#include "sky/flat_grid.h"
#include "sky/panorama_grid.h"
#include "sky/radial_sky.h"

namespace parhelion {

/// Moves points of the picture that show no sky to the nearest that does, or close to it: onto the image circle or the
/// frame of an equirectangular panorama. A rectilinear picture shows sky all over.
class SkyBorder {
 public:
  explicit SkyBorder(const Camera& camera);

  Vec2 moved(Vec2 pixel) const;

  /// The point of a square that is nearest to the optical axis: if that shows no sky, nor does any other.
  Vec2 innermost(Vec2 lo, double size) const;

 private:
  bool fisheye_;
  Vec2 centre_, reach_;  // pixels
};

/// Which rings of a radial sky a pixel lies in, and how much of it in each.
class RadialFootprint {
 public:
  /// For the first `columns` pixels of each row. The sky must outlive the footprint.
  RadialFootprint(const Camera& camera, const RadialSky& sky, int columns);

  /// Takes a row of the picture, then a pixel of it.
  void setRow(int y);
  void setPixel(int x);

  /// The rings from first() to last() hold the pixel; they are none where it shows no sky.
  int first() const { return first_; }
  int last() const { return last_; }

  /// Solid angle (sr) of the pixel's part in a ring. They add up to the pixel's.
  double solidAngle(int bin) const { return share_[static_cast<std::size_t>(bin)] * perShare_; }

 private:
  /// A point of the picture, or if that shows no sky, one on the border of the sky next to it.
  struct Point {
    Vec3 toSky;
    double place;  // among the rings
    bool moved;    // to the border
  };

  /// A square of the picture.
  struct Cell {
    Vec2 lo;         // pixels
    double size;     // pixels
    Point at[2][2];  // corners, [y][x]
  };

  Point pointAt(Vec2 pixel) const { return pointToward(camera_.toSky(pixel), pixel); }
  Point pointToward(const std::optional<Vec3>& seen, Vec2 pixel) const;
  Point pointOnGrid(int twiceX, int twiceY) const;
  std::vector<Point> cornersAt(int y) const;
  Vec2 slopeAt(int x) const;
  double bendAt(int x) const;
  double steepness(const Vec2& slope, double gx, double gy) const;
  static double area(const Cell& cell, const Point& centre);
  void cover(const Cell& cell, const Point& centre, int depth);
  void split(const Cell& cell, const Point& centre, int depth);
  void spread(double place, double gx, double gy, double shift, double weight);

  Camera camera_;  // sees below the horizon, too
  const RadialSky& sky_;
  SkyBorder border_;
  bool cutsHorizon_;
  int columns_;
  std::optional<PanoramaGrid> grid_;
  std::optional<FlatGrid> flatGrid_;
  std::vector<double> solidAngles_;  // of all pixels
  int row_ = -1;
  std::vector<Point> upper_, lower_;  // corners of the row's pixels
  Vec2 slope_{};                      // relative change of solid angle from pixel to pixel
  double bendX_ = 0.0;                // second difference of the place among the rings from pixel to pixel along x
  std::vector<double> share_;         // of the pixel, by ring; without unit
  double total_ = 0.0, perShare_ = 0.0;
  int first_ = 0, last_ = -1;
};

}  // namespace parhelion
