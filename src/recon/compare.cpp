// SPDX-License-Identifier: Apache-2.0
#include "recon/compare.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "math/portable.h"
#include "parallel/loops.h"
#include "picture/colour_space.h"
#include "recon/sky_means.h"
#include "sky/camera.h"
#include "sky/radiance.h"

namespace parhelion {
namespace {

// All in units of the mean luminance.
constexpr double kRelativeFloor = 0.01;  // added to squares: below a tenth of the mean, errors count as absolute
constexpr double kLogFloor = 0.01;
constexpr double kToneFloor = 0.1;  // brightness grows with the logarithm above it
constexpr double kToneWhite = 100.0;
constexpr double kSmoothing = 1.0;   // pixels
constexpr double kSsimWindow = 1.5;  // pixels
constexpr int kBlock = 16;           // pixels: near neighbours err alike

/// light(pixel) over intercepted light and solid angle.
template <class F>
Plane radiance(const SkyMeans& sky, const Tally& tally, const F& light) {
  Plane plane(tally.width(), tally.height());
  const double perLight = tally.info.intercepted.units() > 0 ? 1.0 / tally.info.interceptedLight() : 0.0;
  for (std::size_t i = 0; i < plane.size(); ++i)
    if (sky.omega[i] > 0.0) plane[i] = perLight * light(static_cast<int>(i)) / sky.omega[i];
  return plane;
}

/// A picture's channels R, G, B, times their weights.
Plane weighted(const Image& image, const Vec3& weights) {
  const auto [r, g, b] = image.rgb();
  Plane plane(image.width, image.height);
  for (std::size_t i = 0; i < plane.size(); ++i) plane[i] = glm::dot(weights, Vec3{(*r)[i], (*g)[i], (*b)[i]});
  return plane;
}

/// Picture and reference.
struct Planes {
  Plane e, a, b;
};

/// Mean luminances, by which pictures are divided.
struct Means {
  double e, a, b;
};

Means means(const SkyMeans& sky, const Planes& planes) {
  const auto mean = [&](const Plane& plane) { return sky.mean([&](std::size_t i) { return plane[i]; }); };
  return {mean(planes.e), mean(planes.a), mean(planes.b)};
}

void divide(Planes& planes, const Means& by) {
  for (std::size_t i = 0; i < planes.e.size(); ++i) {
    if (by.e != 0.0) planes.e[i] /= by.e;
    planes.a[i] /= by.a;
    planes.b[i] /= by.b;
  }
}

struct Estimate {
  double value, error;
};

/// The mean of terms and its standard error, from the spread over blocks: neighbours err alike.
Estimate meanOverBlocks(const SkyMeans& sky, const Plane& terms) {
  const double mean = sky.mean([&](std::size_t i) { return terms[i]; });
  double squares = 0.0;
  int blocks = 0;
  for (int y0 = 0; y0 < terms.height(); y0 += kBlock)
    for (int x0 = 0; x0 < terms.width(); x0 += kBlock) {
      double excess = 0.0, omega = 0.0;
      for (int y = y0; y < std::min(y0 + kBlock, terms.height()); ++y)
        for (int x = x0; x < std::min(x0 + kBlock, terms.width()); ++x) {
          excess += sky.omega.at(x, y) * (terms.at(x, y) - mean);
          omega += sky.omega.at(x, y);
        }
      if (omega <= 0.0) continue;
      squares += excess * excess;
      ++blocks;
    }
  return {mean, blocks > 1 ? std::sqrt(squares * blocks / (blocks - 1)) / sky.all : 0.0};
}

/// The square of the smoothed reference.
Plane referenceSquare(const SkySmoother& smooth, const Planes& planes) {
  Plane reference = smooth([&](std::size_t i) { return 0.5 * (planes.a[i] + planes.b[i]); });
  for (std::size_t i = 0; i < reference.size(); ++i) reference[i] *= reference[i];
  return reference;
}

/// Mean of (e - A)(e - B) / (square + floor).
Estimate relativeError(const SkyMeans& sky, const Planes& planes, const Plane& square) {
  const auto& [e, a, b] = planes;
  Plane terms(e.width(), e.height());
  for (std::size_t i = 0; i < terms.size(); ++i)
    terms[i] = (e[i] - a[i]) * (e[i] - b[i]) / (square[i] + kRelativeFloor);
  return meanOverBlocks(sky, terms);
}

double logError(const SkyMeans& sky, const Planes& planes) {
  return sky.mean([&](std::size_t i) {
    const double value = std::max(planes.e[i], 0.0) + kLogFloor;  // max lets NaN pass
    return portable::log(value / (planes.a[i] + kLogFloor)) * portable::log(value / (planes.b[i] + kLogFloor));
  });
}

/// Display brightness, 0 for black and 1 for kToneWhite.
Plane toned(Plane plane) {
  const double scale = 1.0 / portable::log(1.0 + kToneWhite / kToneFloor);
  forRows(plane.height(), [&](int y) {
    for (int x = 0; x < plane.width(); ++x)
      plane.at(x, y) = scale * portable::log(1.0 + std::max(plane.at(x, y), 0.0) / kToneFloor);
  });
  return plane;
}

double structuralSimilarity(const SkyMeans& sky, const Planes& planes) {
  Plane mean = planes.a;
  for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = 0.5 * (mean[i] + planes.b[i]);
  const Plane u = toned(planes.e), v = toned(std::move(mean));
  constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;  // for a range of brightness of 1
  const SkySmoother window(sky, kSsimWindow);
  const Plane meanU = window([&](std::size_t i) { return u[i]; }), meanV = window([&](std::size_t i) { return v[i]; });
  const Plane squares = window([&](std::size_t i) { return u[i] * u[i] + v[i] * v[i]; });
  const Plane products = window([&](std::size_t i) { return u[i] * v[i]; });
  return sky.mean([&](std::size_t i) {
    const double product = meanU[i] * meanV[i], square = meanU[i] * meanU[i] + meanV[i] * meanV[i];
    return (2.0 * product + kC1) * (2.0 * (products[i] - product) + kC2) /
           ((square + kC1) * (squares[i] - square + kC2));
  });
}

Planes luminances(const SkyMeans& sky, const Image& image, const Tally& a, const Tally* b) {
  // Adaptation to the white changes the luminance of colours, so that of a tally is not that of its Rec.709 colour.
  const Mat3 toXyz = glm::inverse(xyzToRec709(a.info.white));
  Planes planes{weighted(image, {toXyz[0].y, toXyz[1].y, toXyz[2].y}), {}, {}};
  if (b != nullptr) {
    planes.a = radiance(sky, a, [&](int pixel) { return a.luminance(pixel); });
    planes.b = radiance(sky, *b, [&](int pixel) { return b->luminance(pixel); });
  } else {
    planes.a = radiance(sky, a, [&](int pixel) { return 2.0 * a.firstHalf(pixel); });
    planes.b = radiance(sky, a, [&](int pixel) { return 2.0 * (a.luminance(pixel) - a.firstHalf(pixel)); });
  }
  return planes;
}

std::array<double, 3> colourErrors(const SkyMeans& sky, const SkySmoother& smooth, const Image& image, const Tally& a,
                                   const Tally& b, const Means& by) {
  const Image imageA = plainRadiance(a), imageB = plainRadiance(b);
  std::array<Planes, 3> channels;
  Plane square(image.width, image.height);
  for (int c = 0; c < 3; ++c) {
    Vec3 weights(0.0);
    weights[c] = 1.0;
    Planes& channel = channels[static_cast<std::size_t>(c)];
    channel = {weighted(image, weights), weighted(imageA, weights), weighted(imageB, weights)};
    divide(channel, by);
    const Plane own = referenceSquare(smooth, channel);
    for (std::size_t i = 0; i < square.size(); ++i) square[i] += own[i] / 3.0;
  }
  std::array<double, 3> errors{};
  for (std::size_t c = 0; c < 3; ++c) errors[c] = relativeError(sky, channels[c], square).value;
  return errors;
}

}  // namespace

void requireSamePicture(const TallyInfo& a, const TallyInfo& b) {
  if (a.camera.width != b.camera.width || a.camera.height != b.camera.height)
    throw std::invalid_argument("their resolutions differ");
  if (a.camera != b.camera) throw std::invalid_argument("their cameras differ");
  if (a.sunElevation != b.sunElevation || a.sunDiameter != b.sunDiameter || a.white != b.white)
    throw std::invalid_argument("their suns differ");
}

bool shareRays(const TallyInfo& a, const TallyInfo& b) {
  if (a.seed != b.seed) return false;
  for (const RayRange& r : a.rays)
    for (const RayRange& s : b.rays)
      if (r.first < s.first + s.count && s.first < r.first + r.count) return true;
  return false;
}

void requireReferencePair(const TallyInfo& a, const TallyInfo& b) {
  requireSamePicture(a, b);
  if (shareRays(a, b))
    throw std::invalid_argument("they hold the same rays of the same seed, trace one with another seed");
}

Comparison compare(const Image& image, const Tally& a, const Tally* b) {
  if (image.width != a.width() || image.height != a.height())
    throw std::invalid_argument("picture and reference differ in size");
  if (b != nullptr) requireReferencePair(a.info, b->info);
  const SkyMeans sky(a.info.camera);
  Planes planes = luminances(sky, image, a, b);
  const Means by = means(sky, planes);
  if (!(by.a > 0.0 && by.b > 0.0)) throw std::invalid_argument("half of the reference holds no light");

  Comparison result;
  result.energyError = 2.0 * by.e / (by.a + by.b) - 1.0;

  divide(planes, by);
  constexpr double kDust = 1e-9;  // of the mean: rounding
  result.negativePixels = sky.mean([&](std::size_t i) { return planes.e[i] < -kDust ? 1.0 : 0.0; });
  const SkySmoother smooth(sky, kSmoothing);
  const Estimate relative = relativeError(sky, planes, referenceSquare(smooth, planes));
  result.relMse = relative.value;
  result.relMseError = relative.error;
  result.mse = sky.mean([&](std::size_t i) { return (planes.e[i] - planes.a[i]) * (planes.e[i] - planes.b[i]); });
  result.logMse = logError(sky, planes);
  result.ssim = structuralSimilarity(sky, planes);
  if (b != nullptr && a.colours() > 1) result.relMseRgb = colourErrors(sky, smooth, image, a, *b, by);
  return result;
}

}  // namespace parhelion
