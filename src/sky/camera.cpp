// SPDX-License-Identifier: Apache-2.0
#include "sky/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "math/portable.h"
#include "math/rotation.h"
#include "picture/image.h"
#include "sky/lens.h"

namespace parhelion {
namespace {

// Cosines of unit vectors are off by a few 1e-16; light on the image circle is to count as inside.
constexpr double kCosineSlack = 1e-14;

constexpr double kSameAngle = 1e-12;  // rad; more than rounding from degrees

/// Degrees that a projection can show.
Range widest(Projection projection) {
  return visitProjection(projection, [](auto facts) { return facts.fieldOfView; });
}

bool withinLimit(Projection projection, double fullAngle) {
  const Range limit = widest(projection);
  return limit.hiOpen ? fullAngle < radians(limit.hi) : fullAngle <= radians(limit.hi) * projections::kFullAngleSlack;
}

bool isAzimuthal(Projection projection) {
  return visitProjection(projection, [](auto facts) { return facts.isAzimuthal; });
}

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(std::string("camera: ") + message);
}

CameraSettings validated(const CameraSettings& s) {
  require(std::isfinite(s.azimuth) && std::isfinite(s.roll), "azimuth and roll must be finite");
  require(std::abs(s.elevation) <= 0.5 * kPi * projections::kFullAngleSlack,
          "elevation must lie within 90 degrees of the horizon");
  require(s.width >= 1 && s.height >= 1, "a picture has at least one pixel");
  require(s.width <= kMaxImageSide && s.height <= kMaxImageSide, "a picture has at most 32768 pixels a side");
  require(static_cast<long long>(s.width) * s.height <= kMaxImagePixels, "a picture has at most 2^28 pixels");
  require(s.fieldOfView > 0.0 && withinLimit(s.projection, s.fieldOfView),
          "the field of view must be positive and within what the projection can show");
  const bool isFixed = showsHemispheres(s.projection);
  require(!isFixed || std::abs(s.fieldOfView - kPi) < kSameAngle, "a picture of hemispheres shows 180 degrees of each");
  require(s.width % discs(s.projection) == 0, "two hemispheres side by side need an even width");
  require(s.imageCircle == 0.0 || (isFisheye(s.projection) && !isFixed), "only a fisheye has an image circle");
  require(s.imageCircle >= 0.0 && withinLimit(s.projection, s.imageCircle),
          "the image circle must be within what the projection can show");
  const Distortion& d = s.distortion;
  require(std::isfinite(d.k1) && std::isfinite(d.k2) && std::isfinite(d.k3), "distortion must be finite");
  require(d.none() || (isAzimuthal(s.projection) && !isFixed), "only single lenses have distortion");
  require(std::isfinite(s.shift.x) && std::isfinite(s.shift.y), "a shift must be finite");
  require(s.shift == Shift() || (isAzimuthal(s.projection) && !isFixed),
          "only the picture of a single lens can be shifted");
  return s;
}

/// Distance from the picture's centre, in focal lengths, at an angle from the optical axis.
double radiusAt(Projection projection, double angle) {
  return visitProjection(projection, [angle](auto facts) { return facts.radiusAt(angle); });
}

double extentPixels(const CameraSettings& s) {
  if (showsHemispheres(s.projection)) return std::min(s.width / discs(s.projection), s.height);
  const double width = s.width, height = s.height;
  switch (s.fieldOfViewAxis) {
    case FieldOfViewAxis::horizontal:
      return width;
    case FieldOfViewAxis::vertical:
      return height;
    case FieldOfViewAxis::diagonal:
      return std::sqrt(width * width + height * height);
  }
  throw std::invalid_argument("camera: no such axis of the field of view");
}

/// A direction after half a turn about a unit axis.
std::optional<Vec3> halfATurn(const std::optional<Vec3>& direction, const Vec3& axis) {
  if (!direction) return std::nullopt;
  return 2.0 * glm::dot(*direction, axis) * axis - *direction;
}

/// Angle of the image circle from the axis.
double maxAngle(const CameraSettings& s) {
  const double limit = 0.5 * radians(widest(s.projection).hi);
  if (s.imageCircle > 0.0) return std::min(0.5 * s.imageCircle, limit);
  return std::min(0.5 * std::max(kPi, s.fieldOfView), limit);
}

}  // namespace

Camera::Camera(const CameraSettings& settings)
    : settings_(validated(settings)),
      forward_(skyDirection(settings.azimuth, settings.elevation)),
      centre_(0.5 * settings.width / discs(settings.projection), 0.5 * settings.height),
      discStep_(discs(settings.projection) > 1 ? 0.5 * settings.width : 0.0),
      focal_(0.5 * extentPixels(settings) / radiusAt(settings.projection, 0.5 * settings.fieldOfView)),
      idealRadius_(std::numeric_limits<double>::infinity()),
      circleRadius_(std::numeric_limits<double>::infinity()),
      minCosine_(std::numeric_limits<double>::min()) {
  centre_ += focal_ * Vec2(-settings.shift.x, settings.shift.y);

  // Up is d skyDirection / d elevation, which is defined at the zenith too.
  const auto [sinAz, cosAz] = portable::sincos(settings.azimuth);
  const auto [sinEl, cosEl] = portable::sincos(settings.elevation);
  const Vec3 up{-sinEl * cosAz, sinEl * sinAz, cosEl};
  const Vec3 observersRight = glm::cross(forward_, up);
  const Vec3 right = isMirrored(settings.projection) ? -observersRight : observersRight;

  // A camera turned clockwise has its top turned toward the picture's right.
  const auto [sinRoll, cosRoll] = portable::sincos(settings.roll);
  up_ = cosRoll * up + sinRoll * right;
  right_ = cosRoll * right - sinRoll * up;

  if (isFisheye(settings.projection)) {
    idealRadius_ = circleRadius_ = radiusAt(settings.projection, maxAngle(settings));
    minCosine_ = portable::cos(maxAngle(settings)) - kCosineSlack;
  }
  if (!settings.distortion.none()) limitDistortion();
  if (!(settings.shift == Shift())) requireSky();
}

Vec2 Camera::farthestCorner() const {
  const double discWidth = settings_.width / discs(settings_.projection), height = settings_.height;
  return {2.0 * centre_.x >= discWidth ? 0.0 : discWidth, 2.0 * centre_.y >= height ? 0.0 : height};
}

void Camera::requireSky() const {
  const Vec2 nearest = glm::clamp(centre_, Vec2(0.0), Vec2(settings_.width, settings_.height));
  require(glm::length(nearest - centre_) < circleRadius_ * focal_,
          "the shift moves the picture out of all that the lens shows");
}

void Camera::limitDistortion() {
  const double fold = settings_.distortion.foldRadius(), corner = glm::length(farthestCorner() - centre_) / focal_;
  if (fold < idealRadius_) {
    require(settings_.distortion.distorted(fold) >= corner,
            "the distortion folds the picture over before it reaches the corners");
    idealRadius_ = fold;
    visitProjection(settings_.projection, [&](auto facts) {
      if constexpr (facts.isAzimuthal) minCosine_ = std::max(minCosine_, facts.atSquaredRadius(fold * fold).cosine);
    });
  }
  // Where nothing folds, the radius grows without end.
  circleRadius_ = std::isinf(idealRadius_) ? idealRadius_ : settings_.distortion.distorted(idealRadius_);
}

bool Camera::isMirrorSymmetric() const {
  const double turns = settings_.azimuth / kPi;
  return turns == std::floor(turns) && settings_.roll == 0.0 && discStep_ == 0.0 && settings_.shift.x == 0.0;
}

Lens Camera::lens() const {
  const auto triple = [](const Vec3& v) { return Triple<double>{v.x, v.y, v.z}; };
  return {settings_.projection,
          static_cast<double>(settings_.width),
          static_cast<double>(settings_.height),
          triple(right_),
          triple(up_),
          triple(forward_),
          centre_.x,
          centre_.y,
          discStep_,
          focal_,
          cutsHorizon() ? -kCosineSlack : -2.0,
          minCosine_,
          !settings_.distortion.none(),
          settings_.distortion};
}

std::optional<Vec2> Camera::project(const Vec3& toSky) const {
  const auto [inside, x, y] = lens().project<double>({toSky.x, toSky.y, toSky.z});
  if (!inside) return std::nullopt;
  return Vec2(x, y);
}

std::optional<Vec2> Camera::placeOf(const Vec3& toSky) const {
  const auto [seen, x, y] = lens().place<double>({toSky.x, toSky.y, toSky.z});
  if (!seen) return std::nullopt;
  return Vec2(x, y);
}

std::optional<int> Camera::pixelAt(const Vec3& toSky) const {
  const std::optional<Vec2> p = project(toSky);
  if (!p) return std::nullopt;
  return static_cast<int>(p->y) * settings_.width + static_cast<int>(p->x);
}

std::optional<Vec3> Camera::toSky(Vec2 pixel) const {
  if (!(pixel.x >= 0.0 && pixel.x <= width() && pixel.y >= 0.0 && pixel.y <= height())) return std::nullopt;
  return directionAt(pixel);
}

std::optional<Vec3> Camera::directionAt(Vec2 pixel) const {
  const std::optional<Vec3> direction = directionThere(pixel);
  return direction && cutsHorizon() && direction->z < -kCosineSlack ? std::nullopt : direction;
}

template <class Facts>
std::optional<Vec3> Camera::azimuthalDirection(Facts facts, Vec2 p) const {
  double r2 = p.x * p.x + p.y * p.y;
  const double r = std::sqrt(r2);
  if (r > circleRadius_) return std::nullopt;
  if (!settings_.distortion.none() && r > 0.0) {
    const double ideal = settings_.distortion.undistorted(r, idealRadius_);
    p *= ideal / r;
    r2 = ideal * ideal;
  }
  const auto [cosine, sinePerRadius] = facts.atSquaredRadius(r2);
  return sinePerRadius * (p.x * right_ + p.y * up_) + cosine * forward_;
}

std::optional<Vec3> Camera::directionThere(Vec2 pixel) const {
  const bool isBack = discStep_ > 0.0 && pixel.x >= discStep_;
  const double x = isBack ? pixel.x - discStep_ : pixel.x;
  const Vec2 place{(x - centre_.x) / focal_, (centre_.y - pixel.y) / focal_};
  return visitProjection(settings_.projection, [&](auto facts) -> std::optional<Vec3> {
    if constexpr (facts.discs > 1) {
      if (isBack) return halfATurn(azimuthalDirection(facts, place), up_);
    }
    if constexpr (facts.isAzimuthal) {
      return azimuthalDirection(facts, place);
    } else {
      const std::optional<Vec3> inCamera = facts.direction(place);
      if (!inCamera) return std::nullopt;
      return inCamera->x * right_ + inCamera->y * up_ + inCamera->z * forward_;
    }
  });
}

Vec3 Camera::directionWithin(Vec2 place, bool isBack) const {
  return visitProjection(settings_.projection, [&](auto facts) -> Vec3 {
    if constexpr (facts.isAzimuthal) {
      const double r = glm::length(place);
      if (r > circleRadius_) place *= circleRadius_ * (1.0 - projections::kRounding) / r;
      const std::optional<Vec3> direction = azimuthalDirection(facts, place);
      return isBack ? *halfATurn(direction, up_) : *direction;
    } else {
      const Vec3 v = facts.anywhere(place);
      return v.x * right_ + v.y * up_ + v.z * forward_;
    }
  });
}

}  // namespace parhelion
