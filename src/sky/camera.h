// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "math/conventions.h"
#include "sky/camera_settings.h"

namespace parhelion {

struct Lens;

/// Where in the picture a point of the sky appears. The field of view and the focal length are those of the ideal lens,
/// which a distortion does not change near the axis. Pixel coordinates: x to the right, y down, pixel (i, j) covers [i,
/// i + 1) x [j, j + 1). At roll 0 the picture's up is the direction of growing elevation, at the zenith its limit: the
/// sun's azimuth is at the bottom. The observer's right is at the picture's right, but for a globe, which is seen from
/// outside.
class Camera {
 public:
  /// Throws std::invalid_argument for settings out of range.
  explicit Camera(const CameraSettings& settings);

  const CameraSettings& settings() const { return settings_; }
  int width() const { return settings_.width; }
  int height() const { return settings_.height; }

  /// Where the left of two discs ends and the right one begins, in pixels; 0 in a picture of one.
  double seam() const { return discStep_; }

  /// Where the optical axis meets the picture, pixel coordinates; with a shift perhaps beside it.
  Vec2 axis() const { return centre_; }

  /// The corner of the picture, or of the left one of two discs, that is farthest from the axis.
  Vec2 farthestCorner() const;

  /// Pixels per radian along the optical axis (equirectangular: of longitude and latitude).
  double focalLength() const { return focal_; }

  /// Whether the picture's left half shows the mirror image, in the sun's vertical plane, of what its right half shows.
  bool isMirrorSymmetric() const;

  /// Whether what lies below the horizon is left out, as if the camera could not see it.
  bool cutsHorizon() const { return settings_.horizon == Horizon::cut; }

  /// Pixel coordinates of the sky point toward the unit world vector `toSky`; none outside the picture, behind a
  /// rectilinear camera, outside the image circle and below a horizon that is cut. Light exactly on the border counts
  /// as inside.
  std::optional<Vec2> project(const Vec3& toSky) const;

  /// The same, also beyond the picture's borders; none where it shows no sky at all.
  std::optional<Vec2> placeOf(const Vec3& toSky) const;

  /// The same for lanes; sky/lens.h defines it.
  Lens lens() const;

  /// Row-major index of the pixel in which project(toSky) lies.
  std::optional<int> pixelAt(const Vec3& toSky) const;

  /// Unit world vector toward the sky point at a place in the picture; none where the picture shows no sky.
  std::optional<Vec3> toSky(Vec2 pixel) const;

  /// The same, also beyond the picture's borders.
  std::optional<Vec3> directionAt(Vec2 pixel) const;

  /// Solid angle (sr) of the part of a pixel that shows sky; 0 if none does. The error is below 1e-10 of a whole pixel,
  /// of a lens with distortion that nears the fold of its picture below 1e-6, on a horizon that is cut below 1e-6.
  double solidAngle(int x, int y) const;

  /// How many rows and columns, from the upper left corner, have solid angles that repeat in no other pixel: the rest
  /// is their mirror image.
  int ownRows() const { return hasAlikeQuarters() ? (height() + 1) / 2 : height(); }
  int ownColumns() const { return hasAlikeQuarters() ? (width() + 1) / 2 : width(); }

  /// The same for all pixels, row-major.
  std::vector<double> solidAngles() const;

 private:
  void limitDistortion();
  void requireSky() const;
  bool hasAlikeQuarters() const { return settings_.shift == Shift() && !cutsHorizon(); }

  /// directionAt() as if no horizon were cut.
  std::optional<Vec3> directionThere(Vec2 pixel) const;

  /// Of a rectangle about the centre of projection, in focal lengths, y up or down, whatever the horizon.
  double solidAngleOf(Vec2 lo, Vec2 hi) const;

  // Of the part of a rectangle, y up, that is above the horizon; `isBack` in the right one of two discs.
  double solidAngleAbove(Vec2 lo, Vec2 hi, bool isBack, int depth = 0) const;
  double borderAbove(Vec2 lo, Vec2 hi, bool isBack) const;

  /// The direction at a place in focal lengths, or of the nearest place on the image circle.
  Vec3 directionWithin(Vec2 place, bool isBack) const;

  // Of an azimuthal projection, whose facts (sky/projections.h) are the first argument; lengths in focal lengths.
  template <class Facts>
  std::optional<Vec3> azimuthalDirection(Facts facts, Vec2 place) const;
  template <class Facts>
  double azimuthalSolidAngle(Facts facts, Vec2 lo, Vec2 hi) const;

  /// (1 - cos theta) / r^2 at a distance r from the centre of the distorted picture, given its square.
  template <class Facts>
  double distortedHeight(Facts facts, double squared) const;

  CameraSettings settings_;
  Vec3 right_, up_, forward_;  // world, orthonormal
  Vec2 centre_;                // of projection, pixels; of the left one of two discs
  double discStep_;            // from the left disc to the right one, pixels; 0 where there is one
  double focal_;               // pixels
  double idealRadius_;         // of what an ideal lens would show, focal lengths; infinite without an end
  double circleRadius_;        // the same where the lens shows it: of the image circle
  double minCosine_;           // of angles from the axis inside the circle, with slack for rounding
};

}  // namespace parhelion
