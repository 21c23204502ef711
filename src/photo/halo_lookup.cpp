// SPDX-License-Identifier: Apache-2.0
#include "photo/halo_lookup.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <glm/common.hpp>

#include "sky/full_turn.h"

namespace parhelion {
namespace {

/// Whether two cameras differ in nothing but the size of their pixels and how far their pictures reach.
bool sameButForScale(CameraSettings a, const CameraSettings& b) {
  a.fieldOfViewAxis = b.fieldOfViewAxis;
  a.fieldOfView = b.fieldOfView;
  a.imageCircle = b.imageCircle;
  a.horizon = b.horizon;
  a.width = b.width;
  a.height = b.height;
  return a == b;
}

/// Relative. Pixels that differ by less are of one size: over the largest picture that adds up to less than one.
constexpr double kSameSize = 1e-6;

/// Which pixels show sky, and be it in part.
std::vector<bool> showsSky(const Camera& camera) {
  std::vector<bool> shown(static_cast<std::size_t>(camera.width()) * camera.height(), true);
  if (!isFisheye(camera.settings().projection) && !camera.cutsHorizon()) return shown;
  const std::vector<double> solidAngles = camera.solidAngles();
  for (std::size_t i = 0; i < shown.size(); ++i) shown[i] = solidAngles[i] > 0.0;
  return shown;
}

double finite(float sample) { return std::isfinite(sample) ? sample : 0.0; }

}  // namespace

HaloLookup::HaloLookup(const Image& halo, const CameraSettings& haloCamera, const CameraSettings& photoCamera)
    : haloCamera_(haloCamera),
      photoCamera_(photoCamera),
      squares_(std::max(1, static_cast<int>(haloCamera_.focalLength() / photoCamera_.focalLength()))),
      finer_(haloCamera_.focalLength() > (1.0 + kSameSize) * squares_ * photoCamera_.focalLength()),
      sameLens_(sameButForScale(haloCamera, photoCamera) && haloCamera_.seam() == 0.0),
      // A panorama whose width is no multiple of the squares ends in narrower ones, which are no whole neighbours. Nor
      // may a square lie across the seam of two discs.
      wraps_(isFullTurn(haloCamera)) {
  if (halo.width != haloCamera.width || halo.height != haloCamera.height)
    throw std::invalid_argument("the halo's picture does not have its camera's size");
  if (wraps_ || haloCamera_.seam() > 0.0) {
    while (halo.width / discs(haloCamera.projection) % squares_ != 0) --squares_;
  }
  const auto rgb = halo.rgb();
  width_ = (halo.width + squares_ - 1) / squares_;
  height_ = (halo.height + squares_ - 1) / squares_;
  light_.resize(static_cast<std::size_t>(width_) * height_);
  sky_.resize(light_.size());
  const std::vector<bool> shown = showsSky(haloCamera_);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const int right = std::min(halo.width, (x + 1) * squares_), bottom = std::min(halo.height, (y + 1) * squares_);
      Vec3 sum(0.0);
      int seen = 0;
      for (int v = y * squares_; v < bottom; ++v) {
        for (int u = x * squares_; u < right; ++u) {
          const std::size_t i = static_cast<std::size_t>(v) * halo.width + u;
          if (!shown[i]) continue;
          ++seen;
          sum += Vec3(finite((*rgb[0])[i]), finite((*rgb[1])[i]), finite((*rgb[2])[i]));
        }
      }
      const std::size_t square = static_cast<std::size_t>(y) * width_ + x;
      light_[square] = sum / std::max(1.0, static_cast<double>(seen));
      sky_[square] = static_cast<double>(seen) / ((right - x * squares_) * (bottom - y * squares_));
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

/// The column of squares next to one about a place of the halo's picture.
int HaloLookup::column(int x, double place) const {
  if (wraps_) return (x % width_ + width_) % width_;
  const int seam = static_cast<int>(haloCamera_.seam()) / squares_;
  if (seam > 0) return place < haloCamera_.seam() ? std::clamp(x, 0, seam - 1) : std::clamp(x, seam, width_ - 1);
  return std::clamp(x, 0, width_ - 1);
}

std::optional<Vec3> HaloLookup::lightAt(Vec2 place) const {
  const auto found = haloPlace(place);
  if (!found) return std::nullopt;
  const Vec2 p = *found / static_cast<double>(squares_) - 0.5;  // the centre of the first square is 0
  const Vec2 corner = glm::floor(p), share = p - corner;
  Vec3 sum(0.0);
  double weights = 0.0;
  for (const int dy : {0, 1}) {
    for (const int dx : {0, 1}) {
      const int x = column(static_cast<int>(corner.x) + dx, found->x);
      const int y = std::clamp(static_cast<int>(corner.y) + dy, 0, height_ - 1);
      const std::size_t square = static_cast<std::size_t>(y) * width_ + x;
      const double weight = (dx == 0 ? 1.0 - share.x : share.x) * (dy == 0 ? 1.0 - share.y : share.y) * sky_[square];
      sum += weight * light_[square];
      weights += weight;
    }
  }
  return weights > 0.0 ? std::optional(sum / weights) : std::nullopt;
}

std::optional<Vec3> HaloLookup::at(Vec2 place) const {
  if (!finer_) return lightAt(place);
  Vec3 sum(0.0);
  int seen = 0;
  for (const Vec2& quarter : {Vec2(-0.25, -0.25), Vec2(0.25, -0.25), Vec2(-0.25, 0.25), Vec2(0.25, 0.25)}) {
    const auto light = lightAt(place + quarter);
    if (!light) continue;
    sum += *light;
    ++seen;
  }
  return seen > 0 ? std::optional(sum / static_cast<double>(seen)) : std::nullopt;
}

}  // namespace parhelion
