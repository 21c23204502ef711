// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include <glm/geometric.hpp>

#include "image/camera_settings.h"
#include "math/conventions.h"
#include "math/portable.h"

namespace parhelion {

/// Largest width or height, and largest number of pixels, of a picture.
inline constexpr int kMaxImageSide = 32768;
inline constexpr int kMaxImagePixels = 1 << 28;

/// The projection's name as scene files and image attributes spell it, "fisheye-equal-area" for one.
std::string_view name(Projection projection);

/// Whether the projection has an image circle.
bool isFisheye(Projection projection);

/// Where in the picture a point of the sky appears. Pixel coordinates: x to the right, y down, pixel (i, j) covers
/// [i, i + 1) x [j, j + 1). At roll 0 the picture's up is the direction of growing elevation, at the zenith its limit:
/// the sun's azimuth is at the bottom. The observer's right is at the picture's right, always.
class Camera {
 public:
  /// Throws std::invalid_argument for settings out of range.
  explicit Camera(const CameraSettings& settings);

  const CameraSettings& settings() const { return settings_; }
  int width() const { return settings_.width; }
  int height() const { return settings_.height; }

  /// Pixels per radian along the optical axis (equirectangular: of longitude and latitude).
  double focalLength() const { return focal_; }

  /// Pixel coordinates of the sky point toward the unit world vector `toSky`; none outside the picture, behind a
  /// rectilinear camera and outside the image circle. Light exactly on the border counts as inside.
  std::optional<Vec2> project(const Vec3& toSky) const;

  /// Row-major index of the pixel in which project(toSky) lies.
  std::optional<int> pixelAt(const Vec3& toSky) const {
    const std::optional<Vec2> p = project(toSky);
    if (!p) return std::nullopt;
    return static_cast<int>(p->y) * settings_.width + static_cast<int>(p->x);
  }

  /// Unit world vector toward the sky point at a place in the picture; none where the picture shows no sky.
  std::optional<Vec3> toSky(Vec2 pixel) const;

  /// Solid angle (sr) of the part of a pixel that shows sky; 0 if none does. The error is below 1e-10 of a whole pixel.
  double solidAngle(int x, int y) const;

  /// The same for all pixels, row-major.
  std::vector<double> solidAngles() const;

 private:
  static double onePlusCosine(const Vec3& v);
  double radiusPerSine(const Vec3& v) const;
  double fisheyeSolidAngle(Vec2 lo, Vec2 hi) const;

  // project() shrinks the picture by this much toward its centre, so that light exactly on the border or on the image
  // circle (the horizon, the poles, the antisolar point) falls inside in spite of rounding, which is a thousand times
  // smaller. 1e-12 of half a picture is far below a pixel.
  static constexpr double kShrink = 1.0 - 1e-12;

  CameraSettings settings_;
  Vec3 right_, up_, forward_;  // world, orthonormal
  Vec2 centre_;                // pixels
  double focal_;               // pixels
  double circleRadius_;        // of the image circle, focal lengths; infinite without one
  double minCosine_;           // of angles from the axis inside the circle, with slack for rounding
};

/// 1 + cos theta of a unit camera vector without cancellation near the antipode of the axis.
inline double Camera::onePlusCosine(const Vec3& v) {
  return v.z > 0.0 ? 1.0 + v.z : (v.x * v.x + v.y * v.y) / (1.0 - v.z);
}

/// r / sin theta, r in focal lengths: the factor from the camera vector's (x, y) to the picture.
inline double Camera::radiusPerSine(const Vec3& v) const {
  switch (settings_.projection) {
    case Projection::rectilinear:
      return 1.0 / v.z;
    case Projection::fisheyeEqualArea:
      return std::sqrt(2.0 / onePlusCosine(v));
    case Projection::fisheyeStereographic:
      return 2.0 / onePlusCosine(v);
    case Projection::fisheyeEquidistant: {
      const double sine = std::sqrt(v.x * v.x + v.y * v.y);
      return sine > 0.0 ? portable::atan2(sine, v.z) / sine : 1.0;
    }
    case Projection::fisheyeOrthographic:
    case Projection::equirectangular:
      break;
  }
  return 1.0;
}

inline std::optional<Vec2> Camera::project(const Vec3& toSky) const {
  Vec3 v{glm::dot(toSky, right_), glm::dot(toSky, up_), glm::dot(toSky, forward_)};
  Vec2 p;  // focal lengths, y up
  if (settings_.projection == Projection::equirectangular) {
    p = {portable::atan2(v.x, v.z), portable::atan2(v.y, std::sqrt(v.x * v.x + v.z * v.z))};
  } else {
    if (!(v.z >= minCosine_)) return std::nullopt;
    // The antipode is the whole image circle and has no direction of its own: give it the left. The square of this
    // sine is still a normal number.
    constexpr double kLeastSine = 1e-150;
    if (v.z < 0.0 && v.x * v.x + v.y * v.y < kLeastSine * kLeastSine) v = {-kLeastSine, 0.0, v.z};
    const double factor = radiusPerSine(v);
    p = {v.x * factor, v.y * factor};
  }
  const Vec2 pixel{centre_.x + p.x * (focal_ * kShrink), centre_.y - p.y * (focal_ * kShrink)};
  const bool inside = pixel.x >= 0.0 && pixel.x < settings_.width && pixel.y >= 0.0 && pixel.y < settings_.height;
  if (!inside) return std::nullopt;
  return pixel;
}

}  // namespace parhelion
