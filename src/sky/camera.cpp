// SPDX-License-Identifier: Apache-2.0
#include "sky/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "math/portable.h"
#include "math/rotation.h"
#include "picture/image.h"

namespace parhelion {
namespace {

// Full angles given in degrees may end up an ulp above 2 pi.
constexpr double kAngleSlack = 1.0 + 1e-12;

// Cosines of unit vectors are off by a few 1e-16; light on the image circle is to count as inside.
constexpr double kCosineSlack = 1e-14;

/// The largest full angle a projection can show, and whether it can show that angle itself.
struct AngleLimit {
  double angle;
  bool included;
};

AngleLimit angleLimit(Projection projection) {
  switch (projection) {
    case Projection::rectilinear:
      return {kPi, false};
    case Projection::fisheyeOrthographic:
      return {kPi, true};
    case Projection::fisheyeStereographic:
      return {2.0 * kPi, false};
    case Projection::fisheyeEqualArea:
    case Projection::fisheyeEquidistant:
    case Projection::equirectangular:
      break;
  }
  return {2.0 * kPi, true};
}

bool withinLimit(Projection projection, double fullAngle) {
  const AngleLimit limit = angleLimit(projection);
  return limit.included ? fullAngle <= limit.angle * kAngleSlack : fullAngle < limit.angle;
}

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(std::string("camera: ") + message);
}

CameraSettings validated(const CameraSettings& s) {
  require(std::isfinite(s.azimuth) && std::isfinite(s.roll), "azimuth and roll must be finite");
  require(std::abs(s.elevation) <= 0.5 * kPi * kAngleSlack, "elevation must lie within 90 degrees of the horizon");
  require(s.width >= 1 && s.height >= 1, "a picture has at least one pixel");
  require(s.width <= kMaxImageSide && s.height <= kMaxImageSide, "a picture has at most 32768 pixels a side");
  require(static_cast<long long>(s.width) * s.height <= kMaxImagePixels, "a picture has at most 2^28 pixels");
  require(s.fieldOfView > 0.0 && withinLimit(s.projection, s.fieldOfView),
          "the field of view must be positive and within what the projection can show");
  require(s.imageCircle == 0.0 || isFisheye(s.projection), "only a fisheye has an image circle");
  require(s.imageCircle >= 0.0 && withinLimit(s.projection, s.imageCircle),
          "the image circle must be within what the projection can show");
  const Distortion& d = s.distortion;
  require(std::isfinite(d.k1) && std::isfinite(d.k2) && std::isfinite(d.k3), "distortion must be finite");
  require(d.none() || s.projection != Projection::equirectangular, "only lenses have distortion");
  return s;
}

/// Distance from the picture's centre, in focal lengths, at an angle from the optical axis.
double radiusAt(Projection projection, double angle) {
  switch (projection) {
    case Projection::rectilinear:
      return portable::tan(angle);
    case Projection::fisheyeEqualArea:
      return 2.0 * portable::sin(0.5 * angle);
    case Projection::fisheyeStereographic:
      return 2.0 * portable::tan(0.5 * angle);
    case Projection::fisheyeOrthographic:
      return portable::sin(angle);
    case Projection::fisheyeEquidistant:
    case Projection::equirectangular:
      break;
  }
  return angle;
}

double extentPixels(const CameraSettings& s) {
  const double width = s.width, height = s.height;
  switch (s.fieldOfViewAxis) {
    case FieldOfViewAxis::horizontal:
      return width;
    case FieldOfViewAxis::vertical:
      return height;
    case FieldOfViewAxis::diagonal:
      break;
  }
  return std::sqrt(width * width + height * height);
}

/// Angle of the image circle from the axis.
double maxAngle(const CameraSettings& s) {
  if (s.imageCircle > 0.0) return std::min(0.5 * s.imageCircle, 0.5 * angleLimit(s.projection).angle);
  return std::min(0.5 * std::max(kPi, s.fieldOfView), 0.5 * angleLimit(s.projection).angle);
}

}  // namespace

std::string_view name(Projection projection) {
  switch (projection) {
    case Projection::rectilinear:
      return "rectilinear";
    case Projection::fisheyeEqualArea:
      return "fisheye-equal-area";
    case Projection::fisheyeEquidistant:
      return "fisheye-equidistant";
    case Projection::fisheyeStereographic:
      return "fisheye-stereographic";
    case Projection::fisheyeOrthographic:
      return "fisheye-orthographic";
    case Projection::equirectangular:
      break;
  }
  return "equirectangular";
}

bool isFisheye(Projection projection) {
  return projection != Projection::rectilinear && projection != Projection::equirectangular;
}

Camera::Camera(const CameraSettings& settings)
    : settings_(validated(settings)),
      forward_(skyDirection(settings.azimuth, settings.elevation)),
      centre_(0.5 * settings.width, 0.5 * settings.height),
      focal_(0.5 * extentPixels(settings) / radiusAt(settings.projection, 0.5 * settings.fieldOfView)),
      idealRadius_(std::numeric_limits<double>::infinity()),
      circleRadius_(std::numeric_limits<double>::infinity()),
      minCosine_(std::numeric_limits<double>::min()) {
  // Up is d skyDirection / d elevation, which is defined at the zenith too.
  const auto [sinAz, cosAz] = portable::sincos(settings.azimuth);
  const auto [sinEl, cosEl] = portable::sincos(settings.elevation);
  const Vec3 up{-sinEl * cosAz, sinEl * sinAz, cosEl};
  const Vec3 right = glm::cross(forward_, up);

  // A camera turned clockwise has its top turned toward the observer's right.
  const auto [sinRoll, cosRoll] = portable::sincos(settings.roll);
  up_ = cosRoll * up + sinRoll * right;
  right_ = cosRoll * right - sinRoll * up;

  if (isFisheye(settings.projection)) {
    idealRadius_ = circleRadius_ = radiusAt(settings.projection, maxAngle(settings));
    minCosine_ = portable::cos(maxAngle(settings)) - kCosineSlack;
  }
  if (!settings.distortion.none()) limitDistortion();
}

void Camera::limitDistortion() {
  const double fold = settings_.distortion.foldRadius(), corner = glm::length(centre_) / focal_;
  if (fold < idealRadius_) {
    require(settings_.distortion.distorted(fold) >= corner,
            "the distortion folds the picture over before it reaches the corners");
    idealRadius_ = fold;
    minCosine_ = std::max(minCosine_, atSquaredRadius(fold * fold).cosine);
  }
  // Where nothing folds, the radius grows without end.
  circleRadius_ = std::isinf(idealRadius_) ? idealRadius_ : settings_.distortion.distorted(idealRadius_);
}

bool Camera::isMirrorSymmetric() const {
  const double turns = settings_.azimuth / kPi;
  return turns == std::floor(turns) && settings_.roll == 0.0;
}

std::optional<Vec3> Camera::toSky(Vec2 pixel) const {
  if (!(pixel.x >= 0.0 && pixel.x <= width() && pixel.y >= 0.0 && pixel.y <= height())) return std::nullopt;
  return directionAt(pixel);
}

Camera::AxisAngle Camera::atSquaredRadius(double r2) const {
  const double r = std::sqrt(r2);
  switch (settings_.projection) {
    case Projection::rectilinear: {
      const double cosine = 1.0 / std::sqrt(1.0 + r2);
      return {cosine, cosine};
    }
    case Projection::fisheyeEqualArea:
      return {1.0 - 0.5 * r2, std::sqrt(std::max(0.0, 1.0 - 0.25 * r2))};
    case Projection::fisheyeStereographic:
      return {(1.0 - 0.25 * r2) / (1.0 + 0.25 * r2), 1.0 / (1.0 + 0.25 * r2)};
    case Projection::fisheyeOrthographic:
      return {std::sqrt(std::max(0.0, (1.0 - r) * (1.0 + r))), 1.0};
    case Projection::fisheyeEquidistant:
    case Projection::equirectangular:
      break;
  }
  return {portable::cos(r), r > 0.0 ? portable::sin(r) / r : 1.0};
}

std::optional<Vec3> Camera::directionAt(Vec2 pixel) const {
  Vec2 p{(pixel.x - centre_.x) / focal_, (centre_.y - pixel.y) / focal_};
  if (settings_.projection == Projection::equirectangular) {
    if (std::abs(p.x) > kPi * kAngleSlack || std::abs(p.y) > 0.5 * kPi * kAngleSlack) return std::nullopt;
    const auto [sinLon, cosLon] = portable::sincos(p.x);
    const auto [sinLat, cosLat] = portable::sincos(p.y);
    return cosLat * sinLon * right_ + sinLat * up_ + cosLat * cosLon * forward_;
  }
  double r2 = p.x * p.x + p.y * p.y;
  const double r = std::sqrt(r2);
  if (r > circleRadius_) return std::nullopt;
  if (!settings_.distortion.none() && r > 0.0) {
    const double ideal = settings_.distortion.undistorted(r, idealRadius_);
    p *= ideal / r;
    r2 = ideal * ideal;
  }
  const auto [cosine, sinePerRadius] = atSquaredRadius(r2);
  return sinePerRadius * (p.x * right_ + p.y * up_) + cosine * forward_;
}

}  // namespace parhelion
