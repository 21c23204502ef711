// SPDX-License-Identifier: Apache-2.0
#include "sky/draw_sun.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "math/rotation.h"

namespace parhelion {

namespace {

// Samples across the sun's disc, so that a disc smaller than a pixel still brings its light to about a thousandth.
constexpr double kSamplesAcrossDisc = 64.0;
constexpr int kMostSamplesAcrossPixel = 512;

/// Mean radiance of the disc over one pixel, by a grid of samples. Blocks of them that lie beside the disc are not
/// looked at one by one.
class PixelMean {
 public:
  PixelMean(const Camera& camera, const Sun& sun, int x, int y, int samples)
      : camera_(camera), sun_(sun), x_(x), y_(y), samples_(samples) {
    addBlock({0, 0, samples, samples});
  }

  double value() const { return onSky_ > 0 ? sum_ / onSky_ : 0.0; }

 private:
  struct Block {
    int left, top, width, height;  // samples
  };

  std::optional<Vec3> at(double i, double j) const { return camera_.toSky(Vec2(x_ + i / samples_, y_ + j / samples_)); }

  void addBlock(const Block& b) {
    constexpr int kSmall = 4;
    if (b.width <= kSmall && b.height <= kSmall) return addSamples(b);
    if (isBesideDisc(b)) {
      onSky_ += b.width * b.height;
      return;
    }
    const int width = b.width / 2, height = b.height / 2;
    addBlock({b.left, b.top, width, height});
    addBlock({b.left + width, b.top, b.width - width, height});
    addBlock({b.left, b.top + height, width, b.height - height});
    addBlock({b.left + width, b.top + height, b.width - width, b.height - height});
  }

  /// Whether all of a block is sky without the disc. No place in it is twice as far from its middle as its corners.
  bool isBesideDisc(const Block& b) const {
    const auto middle = at(b.left + 0.5 * b.width, b.top + 0.5 * b.height);
    if (!middle) return false;
    double reach = 0.0;
    for (const int i : {b.left, b.left + b.width})
      for (const int j : {b.top, b.top + b.height}) {
        const auto corner = at(i, j);
        if (!corner) return false;
        reach = std::max(reach, angleBetween(*middle, *corner));
      }
    return angleBetween(*middle, sun_.toCentre()) > 0.5 * sun_.diameter() + 2.0 * reach;
  }

  void addSamples(const Block& b) {
    for (int j = b.top; j < b.top + b.height; ++j)
      for (int i = b.left; i < b.left + b.width; ++i) {
        const auto toSky = at(i + 0.5, j + 0.5);
        if (!toSky) continue;
        ++onSky_;
        sum_ += sun_.radiance(angleBetween(*toSky, sun_.toCentre()));
      }
  }

  const Camera& camera_;
  const Sun& sun_;
  int x_, y_, samples_;
  double sum_ = 0.0;
  int onSky_ = 0;
};

void addToPixel(Image& image, int pixel, const Vec3& radiance) {
  for (Channel& channel : image.channels)
    for (int c = 0; c < 3; ++c)
      if (channel.name == std::string(1, "RGB"[c])) channel.samples[pixel] += static_cast<float>(radiance[c]);
}

}  // namespace

void drawUndeviatedSun(Image& image, const Camera& camera, const Sun& sun, double share) {
  drawSun(image, camera, sun, [share](const Vec3&) { return Vec3(share); });
}

void drawSun(Image& image, const Camera& camera, const Sun& sun, const std::function<Vec3(const Vec3& toSky)>& light) {
  if (sun.isPoint()) {
    if (const auto pixel = camera.pixelAt(sun.toCentre()))
      addToPixel(image, *pixel,
                 light(sun.toCentre()) / camera.solidAngle(*pixel % camera.width(), *pixel / camera.width()));
    return;
  }
  // All pixels' together are had sooner than each by itself, but for rounding.
  constexpr double kRounding = 1.001;
  const std::vector<double> solidAngles = camera.solidAngles();
  for (int y = 0; y < camera.height(); ++y)
    for (int x = 0; x < camera.width(); ++x) {
      const double about = solidAngles[static_cast<std::size_t>(y) * static_cast<std::size_t>(camera.width()) +
                                       static_cast<std::size_t>(x)];
      const auto centre = camera.toSky(Vec2(x + 0.5, y + 0.5));
      if (!centre) continue;
      // No angle is smaller than its chord.
      const double farthest = 0.5 * sun.diameter() + 4.0 * kRounding * std::sqrt(about);
      if (glm::distance(*centre, sun.toCentre()) > farthest) continue;
      // A pixel's corner is nearer to its centre than twice the side of a square of its solid angle, unless it is
      // stretched; four times leaves room for that.
      const double side = std::sqrt(camera.solidAngle(x, y));
      const double reach = 0.5 * sun.diameter() + 4.0 * side;
      if (angleBetween(*centre, sun.toCentre()) > reach) continue;
      const int samples = std::clamp(static_cast<int>(std::ceil(kSamplesAcrossDisc * side / sun.diameter())), 4,
                                     kMostSamplesAcrossPixel);
      if (const double radiance = PixelMean(camera, sun, x, y, samples).value(); radiance > 0.0)
        addToPixel(image, y * camera.width() + x, radiance * light(*centre));
    }
}

}  // namespace parhelion
