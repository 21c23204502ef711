// SPDX-License-Identifier: Apache-2.0
#include "view/sky_profile.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "math/rotation.h"
#include "picture/colour_space.h"

namespace parhelion {
namespace {

// A quotient such as 60 / 0.25 degrees may come out a few ulp above the whole number it stands for.
constexpr double kQuotientSlack = 1e-9;

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(std::string("profile: ") + message);
}

std::vector<SkyProfileBin> emptyBins(const SkyProfileSettings& s) {
  require(s.from >= 0.0 && s.from < s.to && s.to <= kPi && s.bin > 0.0, "angles must be 0 <= from < to <= 180 degrees");
  const double count = std::ceil((s.to - s.from) / s.bin - kQuotientSlack);
  require(count <= kMaxProfileBins, "there are at most a million bins");
  std::vector<SkyProfileBin> bins(static_cast<std::size_t>(std::max(count, 1.0)));
  for (std::size_t i = 0; i < bins.size(); ++i) {
    bins[i].from = s.from + static_cast<double>(i) * s.bin;
    bins[i].to = i + 1 < bins.size() ? s.from + static_cast<double>(i + 1) * s.bin : s.to;
  }
  return bins;
}

/// What a bin's pixels add up to, w the weight of one and y its luminance.
struct Sums {
  double w = 0.0, wy = 0.0, ww = 0.0, wwy = 0.0, wwyy = 0.0;
  Vec3 light{0.0};
  std::int64_t pixels = 0;

  void add(const Vec3& rgb, double weight) {
    const double y = glm::dot(kRec709Luminance, rgb), square = weight * weight;
    w += weight;
    wy += weight * y;
    light += weight * rgb;
    ww += square;
    wwy += square * y;
    wwyy += square * y * y;
    ++pixels;
  }

  void writeTo(SkyProfileBin& bin) const {
    bin.pixels = pixels;
    if (pixels == 0) return;
    bin.mean = light / w;
    bin.luminance = wy / w;
    if (pixels < 2) return;
    // Variance of a weighted mean of n independent values: n / (n - 1) sum w^2 (y - mean)^2 / (sum w)^2.
    const double scatter = wwyy - 2.0 * bin.luminance * wwy + bin.luminance * bin.luminance * ww;
    const double n = static_cast<double>(pixels);
    bin.error = std::sqrt(std::max(0.0, scatter) * n / (n - 1.0)) / w;
  }
};

/// A pixel in the sky.
struct Patch {
  Vec3 toSky;         // of its middle, not of unit length
  double solidAngle;  // sr
};

/// The pixels of a camera row by row. Neighbours share their corners, so each costs one direction.
class Patches {
 public:
  explicit Patches(const Camera& camera) : camera_(camera), lower_(corners(0)) {}

  /// To be called for y = 0, 1, 2 ...
  void goToRow(int y) {
    upper_ = std::move(lower_);
    lower_ = corners(y + 1);
  }

  /// A pixel of the row; none unless all its corners show sky.
  std::optional<Patch> at(int x) const {
    const auto i = static_cast<std::size_t>(x);
    const auto &a = upper_[i], &b = upper_[i + 1], &c = lower_[i], &d = lower_[i + 1];
    if (!a || !b || !c || !d) return std::nullopt;
    return Patch{*a + *b + *c + *d, 0.5 * glm::length(glm::cross(*d - *a, *b - *c))};
  }

 private:
  std::vector<std::optional<Vec3>> corners(int y) const {
    std::vector<std::optional<Vec3>> row(static_cast<std::size_t>(camera_.width()) + 1);
    for (int x = 0; x <= camera_.width(); ++x) row[static_cast<std::size_t>(x)] = camera_.toSky(Vec2(x, y));
    return row;
  }

  const Camera& camera_;
  std::vector<std::optional<Vec3>> upper_, lower_;
};

std::size_t pixelsOf(const Camera& camera) {
  return static_cast<std::size_t>(camera.width()) * static_cast<std::size_t>(camera.height());
}

bool isFinite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

std::vector<SkyProfileBin> skyProfile(const Image& picture, const Camera& camera, const Vec3& toSun,
                                      const SkyProfileSettings& settings, std::span<const std::uint8_t> share) {
  require(picture.width == camera.width() && picture.height == camera.height(), "the picture is not the camera's");
  require(share.empty() || share.size() == picture.pixels(), "the mask has another size than the picture");
  std::vector<SkyProfileBin> bins = emptyBins(settings);
  std::vector<Sums> sums(bins.size());
  const auto light = picture.rgb();

  Patches patches(camera);
  std::size_t i = 0;
  for (int y = 0; y < camera.height(); ++y) {
    patches.goToRow(y);
    for (int x = 0; x < camera.width(); ++x, ++i) {
      const Vec3 rgb{(*light[0])[i], (*light[1])[i], (*light[2])[i]};
      const double counts = share.empty() ? 1.0 : share[i] / 255.0;
      if (counts == 0.0 || !isFinite(rgb)) continue;
      const std::optional<Patch> patch = patches.at(x);
      if (!patch) continue;
      const double angle = angleBetween(patch->toSky, toSun);
      if (angle < settings.from || angle > settings.to) continue;
      const auto bin = static_cast<std::size_t>((angle - settings.from) / settings.bin);
      sums[std::min(bin, sums.size() - 1)].add(rgb, counts * patch->solidAngle);
    }
  }
  for (std::size_t bin = 0; bin < bins.size(); ++bin) sums[bin].writeTo(bins[bin]);
  return bins;
}

std::vector<std::uint8_t> sharedSky(const Camera& camera, std::span<const std::uint8_t> share, const Camera& other,
                                    std::span<const std::uint8_t> otherShare) {
  require(share.empty() || share.size() == pixelsOf(camera), "the mask has another size than the picture");
  require(otherShare.empty() || otherShare.size() == pixelsOf(other), "the mask has another size than its picture");
  std::vector<std::uint8_t> shared(pixelsOf(camera), 0);
  std::size_t i = 0;
  for (int y = 0; y < camera.height(); ++y)
    for (int x = 0; x < camera.width(); ++x, ++i) {
      const std::optional<Vec3> toSky = camera.toSky(Vec2(x + 0.5, y + 0.5));
      const std::optional<int> there = toSky ? other.pixelAt(*toSky) : std::nullopt;
      if (!there || (!otherShare.empty() && otherShare[static_cast<std::size_t>(*there)] < 128)) continue;
      shared[i] = share.empty() ? 255 : share[i];
    }
  return shared;
}

}  // namespace parhelion
