// SPDX-License-Identifier: Apache-2.0
#include "photo/halo_lookup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace parhelion {
namespace {

/// Whether two cameras differ in nothing but the size of their pixels and how far their pictures reach.
bool sameButForScale(CameraSettings a, const CameraSettings& b) {
  a.fieldOfViewAxis = b.fieldOfViewAxis;
  a.fieldOfView = b.fieldOfView;
  a.imageCircle = b.imageCircle;
  a.width = b.width;
  a.height = b.height;
  return a == b;
}

/// Weights of the four values about a place, `t` of the way from the second to the third.
std::array<double, 4> catmullRom(double t) {
  const double t2 = t * t, t3 = t2 * t;
  return {0.5 * (-t3 + 2.0 * t2 - t), 0.5 * (3.0 * t3 - 5.0 * t2 + 2.0), 0.5 * (-3.0 * t3 + 4.0 * t2 + t),
          0.5 * (t3 - t2)};
}

double finite(float sample) { return std::isfinite(sample) ? sample : 0.0; }

}  // namespace

HaloLookup::HaloLookup(const Image& halo, const CameraSettings& haloCamera, const CameraSettings& photoCamera)
    : haloCamera_(haloCamera),
      photoCamera_(photoCamera),
      squares_(std::max(1, static_cast<int>(haloCamera_.focalLength() / photoCamera_.focalLength()))),
      sameLens_(sameButForScale(haloCamera, photoCamera)),
      // A panorama whose width is no multiple of the squares ends in narrower ones, which are no whole neighbours.
      wraps_(haloCamera.projection == Projection::equirectangular &&
             haloCamera_.focalLength() * 2.0 * kPi < halo.width + 0.5) {
  if (halo.width != haloCamera.width || halo.height != haloCamera.height)
    throw std::invalid_argument("the halo's picture does not have its camera's size");
  if (wraps_) {
    while (halo.width % squares_ != 0) --squares_;
  }
  const auto rgb = halo.rgb();
  width_ = (halo.width + squares_ - 1) / squares_;
  height_ = (halo.height + squares_ - 1) / squares_;
  light_.resize(static_cast<std::size_t>(width_) * height_);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const int right = std::min(halo.width, (x + 1) * squares_), bottom = std::min(halo.height, (y + 1) * squares_);
      Vec3 sum(0.0);
      for (int v = y * squares_; v < bottom; ++v) {
        for (int u = x * squares_; u < right; ++u) {
          const std::size_t i = static_cast<std::size_t>(v) * halo.width + u;
          sum += Vec3(finite((*rgb[0])[i]), finite((*rgb[1])[i]), finite((*rgb[2])[i]));
        }
      }
      light_[static_cast<std::size_t>(y) * width_ + x] =
          sum / static_cast<double>((right - x * squares_) * (bottom - y * squares_));
    }
  }
}

std::optional<Vec2> HaloLookup::haloPlace(Vec2 place) const {
  const auto inside = [this](Vec2 p) {
    return p.x >= 0.0 && p.x <= haloCamera_.width() && p.y >= 0.0 && p.y <= haloCamera_.height();
  };
  if (sameLens_) {
    const Vec2 photoCentre{0.5 * photoCamera_.width(), 0.5 * photoCamera_.height()};
    const Vec2 haloCentre{0.5 * haloCamera_.width(), 0.5 * haloCamera_.height()};
    const Vec2 p = haloCentre + (place - photoCentre) * (haloCamera_.focalLength() / photoCamera_.focalLength());
    return inside(p) ? std::optional(p) : std::nullopt;
  }
  const auto toSky = photoCamera_.toSky(place);
  return toSky ? haloCamera_.project(*toSky) : std::nullopt;
}

int HaloLookup::column(int x) const { return wraps_ ? (x % width_ + width_) % width_ : std::clamp(x, 0, width_ - 1); }

std::optional<Vec3> HaloLookup::at(Vec2 place) const {
  const auto found = haloPlace(place);
  if (!found) return std::nullopt;
  const Vec2 p = *found / static_cast<double>(squares_) - 0.5;  // the centre of the first square is 0
  const double left = std::floor(p.x), top = std::floor(p.y);
  const auto wx = catmullRom(p.x - left), wy = catmullRom(p.y - top);
  Vec3 sum(0.0);
  for (int j = 0; j < 4; ++j) {
    const std::size_t row =
        static_cast<std::size_t>(std::clamp(static_cast<int>(top) + j - 1, 0, height_ - 1)) * width_;
    for (int i = 0; i < 4; ++i) {
      const int x = column(static_cast<int>(left) + i - 1);
      sum +=
          wx[static_cast<std::size_t>(i)] * wy[static_cast<std::size_t>(j)] * light_[row + static_cast<std::size_t>(x)];
    }
  }
  return glm::max(sum, 0.0);
}

}  // namespace parhelion
