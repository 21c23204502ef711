// SPDX-License-Identifier: Apache-2.0
#pragma once

// Tallies with known contents, and their reconstructions in hits per pixel.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/portable.h"
#include "picture/image.h"
#include "random_stream.h"
#include "recon/reconstruct.h"
#include "sky/camera.h"
#include "sky/radiance.h"
#include "sky/tally.h"

namespace parhelion {

/// An equal-area fisheye without an image circle in the picture: a square full of sky, pixels of one solid angle.
inline TallyInfo fullSky(int side) {
  TallyInfo info;
  info.camera.width = info.camera.height = side;
  info.camera.fieldOfView = radians(90.0);
  info.rays = {{0, 1'000'000}};
  info.intercepted = LightTotal(toFixed(1e6));
  return info;
}

/// A Poisson number; long means are added up from short ones.
inline int poisson(double mean, RandomStream& random) {
  int count = 0;
  for (; mean > 20.0; mean -= 20.0) count += poisson(20.0, random);
  const double limit = portable::exp(-mean);
  for (double product = random.next(); product > limit; product *= random.next()) ++count;
  return count;
}

/// Adds hits of a weight to a pixel, every second one to the first half of the rays.
inline void addHits(Tally& tally, int pixel, int count, const Vec3& xyz = Vec3(1.0)) {
  for (int i = 0; i < count; ++i) tally.add(pixel, xyz, (pixel + i) % 2 == 0);
}

/// Poisson hits of mean density(x, y) a pixel, the halves by chance.
template <class Density>
Tally poissonTally(const TallyInfo& info, const Density& density, std::uint64_t seed, double weight = 1.0) {
  Tally tally(info, 1);
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
    RandomStream random(seed, static_cast<std::uint64_t>(pixel), RandomPurpose::path);
    const int count = poisson(density(pixel % tally.width(), pixel / tally.width()), random);
    for (int i = 0; i < count; ++i) tally.add(pixel, Vec3(weight), random.next() < 0.5);
  }
  return tally;
}

inline Image adaptive(const Tally& tally) { return reconstruct(tally, AdaptiveSettings{}).image; }

/// A channel of a reconstruction as light per pixel, the unit of Tally::luminance(); of R = G = B the luminance.
inline std::vector<double> perPixel(const Image& image, const Tally& tally, const char* channel = "G") {
  const std::vector<double> solidAngles = Camera(tally.info.camera).solidAngles();
  const std::vector<float>& samples = *image.find(channel);
  std::vector<double> light(samples.size());
  for (std::size_t i = 0; i < light.size(); ++i)
    light[i] = static_cast<double>(samples[i]) * solidAngles[i] * tally.info.interceptedLight();
  return light;
}

inline std::vector<double> adaptiveLight(const Tally& tally) { return perPixel(adaptive(tally), tally); }

/// Light in the sky's pixels.
inline double lightIn(const Tally& tally) {
  const std::vector<double> solidAngles = Camera(tally.info.camera).solidAngles();
  double sum = 0.0;
  for (int pixel = 0; pixel < tally.pixels(); ++pixel)
    if (solidAngles[static_cast<std::size_t>(pixel)] > 0.0) sum += tally.luminance(pixel);
  return sum;
}

}  // namespace parhelion
