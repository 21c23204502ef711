// SPDX-License-Identifier: Apache-2.0
#include "render/clouded_sky.h"

#include <algorithm>
#include <cmath>

#include "math/portable.h"

namespace parhelion {

namespace {

// Mean cosine of the angle by which crystals scatter what does not pass them undeviated, their halos apart.
constexpr double kCrystalsG = 0.6;
// Of the integrals over half the sky: directions by the sine of the elevation and by azimuth.
constexpr int kRises = 24, kAzimuths = 24;

/// Mean over half the sky, weighted by the sine of the elevation; `side` is 1 above the horizon, -1 below.
template <class F>
auto meanOfHalf(double side, const F& f) {
  decltype(f(Vec3())) sum(0.0);
  double weights = 0.0;
  for (int i = 0; i < kRises; ++i)
    for (int k = 0; k < kAzimuths; ++k) {
      const double rise = (i + 0.5) / kRises, level = std::sqrt(1.0 - rise * rise);
      const portable::SinCos turn = portable::sincos(2.0 * kPi * (k + 0.5) / kAzimuths);
      sum += rise * f(Vec3(level * turn.cos, level * turn.sin, side * rise));
      weights += rise;
    }
  return sum / weights;
}

double meanG(const Scene& scene) {
  double sum = 0.0, weights = 0.0;
  for (const PopulationSettings& population : scene.populations) {
    sum += population.weight * kCrystalsG;
    weights += population.weight;
  }
  for (const HazeSettings& haze : scene.hazes) {
    const auto* own = std::get_if<HenyeyGreenstein>(&haze.phase);
    sum += haze.weight * (own ? own->g : kCrystalsG);
    weights += haze.weight;
  }
  return sum / weights;
}

}  // namespace

CloudFlux cloudFlux(double depth, double rise, double g) {
  const double scaled = (1.0 - g * g) * depth, own = g / (1.0 + g);
  const double taken = 0.75 * (1.0 - own), back = 0.25 * (2.0 - 3.0 * own * rise);
  const double reflected =
      (taken * scaled + (back - taken * rise) * (1.0 - portable::exp(-scaled / rise))) / (1.0 + taken * scaled);
  return {1.0 - reflected, reflected};
}

CloudedSky::CloudedSky(const AirSky& clear, const SlabLight& slab, const Scene& scene)
    : clear_(clear), slab_(slab), isClear_(!scene.cloud), sides_(crystalSides(scene)) {
  if (isClear_) return;
  if (cloudAltitude(scene))
    fromCloud_ = NumberByElevation<Vec3>(
        [&](const Vec3& toSky) { return clear.throughAir(portable::atan2(toSky.z, std::hypot(toSky.x, toSky.y))); });
  g_ = meanG(scene);
  if (slab.isSameAllAround()) {
    direct_ = ByElevation([&](const Vec3& toSky) { return directThrough(toSky); });
    all_ = ByElevation([&](const Vec3& toSky) { return through(toSky); });
  }
  const Vec3 toSun = Sun(scene.sun).toCentre();
  above_ = meanOfHalf(1.0, [&](const Vec3& toSky) { return clear.radiance(toSky); });
  const double diffuse = meanOfHalf(1.0, [&](const Vec3& toSky) { return through(toSky); });
  const Vec3 sun = std::max(0.0, toSun.z) * clear.sunlight(), sky = kPi * above_;
  const double ofSun = toSun.z > 0.0 ? through(toSun) : 0.0;
  const double again = 1.0 / (1.0 - scene.sky.ground * (1.0 - diffuse));
  const Vec3 lit = again * (ofSun * sun + diffuse * sky), clearly = sun + sky;
  for (int c = 0; c < 3; ++c) groundLeft_[c] = clearly[c] > 0.0 ? lit[c] / clearly[c] : diffuse;
  below_ = scene.sky.ground / kPi * lit;
}

double CloudedSky::directThrough(const Vec3& toSky) const { return portable::exp(-slab_.depthToward(toSky)); }

double CloudedSky::through(const Vec3& toSky) const {
  const double rise = std::max(std::abs(toSky.z), kLevelRise);
  return std::max(directThrough(toSky), cloudFlux(slab_.depthToward(toSky) * rise, rise, g_).through);
}

Vec3 CloudedSky::radiance(const Vec3& toSky) const {
  const Vec3 clear = clear_.radiance(toSky);
  if (isClear_) return clear;
  // The horizon of the round earth lies below that of a level cloud, which is seen down to it.
  Vec3 toCloud = toSky;
  if (sides_.above && !sides_.below && toSky.z > portable::sin(clear_.horizon()))
    toCloud.z = std::max(toCloud.z, kLevelRise);
  const bool isUp = toCloud.z > 0.0;
  // Where no crystals are seen is the ground under the cloud, or the sky over it.
  if (!showsCrystals(toCloud)) return isUp || sides_.below ? clear : groundLeft_ * clear;
  const double direct = direct_.isEmpty() ? directThrough(toCloud) : direct_.at(toCloud);
  const double all = all_.isEmpty() ? through(toCloud) : all_.at(toCloud);
  const Vec3 before = clear_.radianceBeforeCloud(toSky), behind = clear - before;
  const Vec3 beyond = isUp ? above_ : below_, returned = isUp ? below_ : above_;
  Vec3 through = fromCloud(toCloud);
  for (int c = 0; c < 3; ++c)
    through[c] = clear_.sunlightAtCloud()[c] > 0.0 ? through[c] / clear_.sunlightAtCloud()[c] : 1.0;
  return (isUp ? groundLeft_ * before + direct * behind : before + direct * groundLeft_ * behind) +
         through * ((all - direct) * beyond + (1.0 - all) * returned);
}

}  // namespace parhelion
