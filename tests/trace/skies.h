// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pictures of the light of clouds, made with and without use of the sky's symmetry, and how far two agree.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "crystals.h"
#include "halos/comparison.h"
#include "sky/look_at.h"
#include "statistics.h"
#include "trace/expose.h"

namespace parhelion::test {

/// The whole sphere, off the sun's azimuth.
inline CameraSettings wholeSphere(int width = 36) {
  return lookAt(Projection::equirectangular, 30.0, 0.0, 0.0, 360.0, width, width / 2);
}

/// Crystals under a sun with a disc and a continuous spectrum.
inline Cloud sunlit(const std::vector<PopulationSettings>& populations, double sunElevation = radians(20.0)) {
  SunSettings sun;
  sun.elevation = sunElevation;
  return Cloud(sun, PublishedIndex{}, populations);
}

inline PopulationSettings plates() { return prismPopulation(0.3, AxisOrientation{Normal{0.0, radians(4.0)}}); }
inline PopulationSettings parryColumns() {
  AxisOrientation parry{Normal{0.5 * kPi, radians(1.0)}};
  parry.roll = Normal{0.0, radians(2.0)};
  return prismPopulation(1.5, parry);
}
inline PopulationSettings lowitzPlates() {
  return prismPopulation(0.4, LowitzOrientation{Normal{0.5 * kPi, radians(2.0)}, UniformRange{0.0, 2.0 * kPi}});
}
inline PopulationSettings pyramids(double upper, double lower) {
  return {"pyramids", 1.0, PyramidSettings{0.4, upper, lower}, RandomOrientation{}};
}

struct View {
  Cloud cloud;
  CameraSettings camera;
};

inline TraceSettings by(Symmetry symmetry, std::uint64_t rays, std::uint64_t seed) {
  return {.rays = rays, .seed = seed, .symmetry = symmetry};
}

/// The picture that rays `firstRay` ... `settings.rays` - 1 make.
inline Tally traceSky(const Cloud& cloud, const CameraSettings& camera, const TraceSettings& settings,
                      std::uint64_t firstRay = 0, int threads = 2) {
  TallyInfo info;
  info.camera = camera;
  info.white = cloud.spectrum().white();
  info.sunElevation = std::asin(cloud.sun().toCentre().z);
  SkyTally tally(info, cloud.spectrum().colours(), different(symmetriesOf(cloud, settings.symmetry)));
  TraceControl control;
  control.threads = threads;
  traceTally(tally, cloud, settings, firstRay, control);
  return tally.flattened();
}

inline double totalLuminance(const Tally& tally) {
  double sum = 0.0;
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) sum += tally.luminance(pixel);
  return sum;
}

/// Luminance of each pixel per unit of intercepted light, one picture against another of other rays, where both know it
/// to a tenth: errors made of few hits are small where the light is too little by chance.
inline Disagreement comparePictures(const Tally& a, const Tally& b) {
  constexpr double kLeast = 10.0;  // standard errors
  const double perA = 1.0 / a.info.interceptedLight(), perB = 1.0 / b.info.interceptedLight();
  Disagreement sum;
  for (int pixel = 0; pixel < a.pixels(); ++pixel) {
    const double lightA = a.luminance(pixel), errorA = a.luminanceError(pixel);
    const double lightB = b.luminance(pixel), errorB = b.luminanceError(pixel);
    if (lightA < kLeast * errorA || lightB < kLeast * errorB) continue;
    sum.add(lightA * perA, errorA * perA, lightB * perB, errorB * perB);
  }
  return sum;
}

/// How far the two halves of a pixel's light are apart: squared, in units of its variance.
inline void addHalves(const Tally& tally, int pixel, SampleMean& apart) {
  const double error = tally.luminanceError(pixel);
  if (!(tally.luminance(pixel) > 10.0 * error)) return;  // not enough hits to know the variance
  const double difference = 2.0 * tally.firstHalf(pixel) - tally.luminance(pixel);
  apart.add(difference * difference / (error * error));
}

/// Pictures of one sky from independent seeds: their mean and scatter, per unit of intercepted light.
struct Replicates {
  std::vector<SampleMean> x, y, z;  // CIE, a pixel each
  std::vector<double> stated;       // mean of the variance of y that the tallies state
  SampleMean total, undeviated;     // luminance of the whole picture, share of undeviated light

  Replicates(const Cloud& cloud, const CameraSettings& camera, TraceSettings settings, int count) {
    for (int i = 0; i < count; ++i, ++settings.seed) add(traceSky(cloud, camera, settings), 1.0 / count);
  }

  /// Mean over some pixels of the variance of luminance: as the pictures scatter, and as the tallies state it.
  double scatterOf(const std::vector<int>& pixels) const {
    double sum = 0.0;
    for (const int pixel : pixels) sum += y[pixel].variance() / static_cast<double>(pixels.size());
    return sum;
  }
  double statedOf(const std::vector<int>& pixels) const {
    double sum = 0.0;
    for (const int pixel : pixels) sum += stated[pixel] / static_cast<double>(pixels.size());
    return sum;
  }

 private:
  void add(const Tally& tally, double share) {
    for (auto* sums : {&x, &y, &z}) sums->resize(tally.pixels());
    stated.resize(tally.pixels());
    const double per = 1.0 / tally.info.interceptedLight();
    for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
      const Vec3 xyz = tally.xyz(pixel);
      x[pixel].add(xyz.x * per);
      y[pixel].add(xyz.y * per);
      z[pixel].add(xyz.z * per);
      const double error = tally.luminanceError(pixel) * per;
      stated[pixel] += share * error * error;
    }
    total.add(totalLuminance(tally) * per);
    undeviated.add(tally.info.undeviatedFraction());
  }
};

/// Standard errors between the means of two samples.
inline double sigmasApart(const SampleMean& a, const SampleMean& b) {
  return std::abs(a.mean() - b.mean()) / std::hypot(a.standardError(), b.standardError());
}

/// X, Y, Z and the sums of pictures of two kinds, errors from the scatter of the replicates.
inline void checkAgree(const Replicates& a, const Replicates& b) {
  for (const auto sums : {&Replicates::x, &Replicates::y, &Replicates::z}) {
    Disagreement d;
    for (std::size_t pixel = 0; pixel < a.y.size(); ++pixel) {
      const SampleMean &p = (a.*sums)[pixel], &q = (b.*sums)[pixel];
      d.add(p.mean(), p.standardError(), q.mean(), q.standardError());
    }
    CHECK(d.compared() > 100);
    CHECK(std::abs(d.sigmas()) < kSigmas);
  }
  CHECK(sigmasApart(a.total, b.total) < kSigmas);
  CHECK(sigmasApart(a.undeviated, b.undeviated) < kSigmas);
}

}  // namespace parhelion::test
