// SPDX-License-Identifier: Apache-2.0
#include "render/air_background.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "air/air_sky.h"
#include "math/portable.h"
#include "math/rotation.h"
#include "optics/spectrum.h"
#include "optics/sun.h"
#include "optics/tables.h"
#include "parallel/loops.h"
#include "parallel/threads.h"
#include "picture/colour_space.h"
#include "render/clouded_sky.h"
#include "render/more_orders.h"
#include "render/slab_light.h"
#include "sky/draw_sun.h"
#include "sky/pixel_mean.h"
#include "sky/radiance.h"

namespace parhelion {

namespace {

constexpr double kMetresPerKilometre = 1000.0;

double altitudeOf(const Scene& scene) { return scene.observer.altitude / kMetresPerKilometre; }

/// Of the cloud, km; none: that of the observer.
std::optional<double> cloudAltitudeOf(const Scene& scene) {
  const std::optional<double> own = cloudAltitude(scene);
  if (!own) return {};
  const double altitude = *own / kMetresPerKilometre;
  // Not between an observer's feet and eyes.
  return crystalSides(scene).above ? std::max(altitude, altitudeOf(scene) + kEyeHeight) : altitude;
}

/// Channels of a picture by what they hold.
struct Planes {
  struct Colours {
    float *r, *g, *b;
  };
  explicit Planes(Image& image) {
    const auto find = [&](const std::string& name) -> float* {
      for (Channel& channel : image.channels)
        if (channel.name == name) return channel.samples.data();
      return nullptr;
    };
    for (const Channel& channel : image.channels) {
      if (channel.name != "R" && !channel.name.ends_with(".R")) continue;
      const std::string before = channel.name.substr(0, channel.name.size() - 1);
      const Colours colours{find(channel.name), find(before + "G"), find(before + "B")};
      if (!colours.g || !colours.b) continue;
      (before.empty() ? whole : layers).push_back(colours);
    }
    variance = find(kVarianceChannel);
    bias = find(kBiasChannel);
  }

  std::vector<Colours> whole, layers;  // `whole` is one
  float *variance, *bias;
};

class Background {
 public:
  Background(Image& image, const Camera& camera, const TallyInfo& info, const Scene& scene, const SlabLight& slab,
             const Image* more)
      : image_(image),
        camera_(camera),
        scene_(scene),
        planes_(image),
        sky_(scene.sky, altitudeOf(scene), scene.sun.elevation, sunBands(), cloudAltitudeOf(scene)),
        toRec709_(xyzToRec709()),
        slab_(slab),
        more_(more),
        clouded_(sky_, slab, scene),
        illuminance_(solarIlluminance(scene.sun.spectrum)),
        fromHalo_(sky_.sunlightAtCloud().y / illuminance_ * (toRec709_ * rec709ToXyz(info.white))),
        sunlight_(toRec709_ * sky_.sunlightAtCloud()) {}

  void add() {
    addHaze(image_, camera_, scene_, slab_.ofHaze());
    slab_.apply(image_, camera_);
    if (more_) addPart(*more_, 1.0, {}, image_);
    forRows(image_.height, [&](int y) {
      for (int x = 0; x < image_.width; ++x) addTo(x, y);
    });
  }

  /// Its disc, with its limb darkening, each part as reddened as its elevation asks for.
  void drawTheSun() {
    const double through = slab_.directIlluminance() / solarIlluminance(scene_.sun.spectrum);
    drawSun(image_, camera_, Sun(scene_.sun), [&](const Vec3& toSky) {
      return through * toRec709_ * sky_.sunlightFrom(portable::atan2(toSky.z, std::hypot(toSky.x, toSky.y)));
    });
  }

 private:
  void addTo(int x, int y) {
    const auto toSky = camera_.toSky(Vec2(x + 0.5, y + 0.5));
    const bool hasIce = toSky && clouded_.showsCrystals(*toSky);
    const Vec3 through = hasIce ? throughAir(*toSky) : Vec3(0.0);
    const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) + std::size_t(x);
    const auto rescale = [&](const Planes::Colours& plane, const Vec3& more) {
      const Vec3 rgb = through * (fromHalo_ * Vec3(plane.r[i], plane.g[i], plane.b[i])) + more;
      plane.r[i] = static_cast<float>(rgb.x);
      plane.g[i] = static_cast<float>(rgb.y);
      plane.b[i] = static_cast<float>(rgb.z);
    };
    for (const Planes::Colours& layer : planes_.layers) rescale(layer, Vec3(0.0));
    for (const Planes::Colours& whole : planes_.whole) rescale(whole, toSky ? behind(*toSky, x, y) : Vec3(0.0));
    const double arriving = hasIce ? clouded_.fromCloud(*toSky).y : 0.0;
    const auto brightness = static_cast<float>(arriving / illuminance_);
    if (planes_.variance) planes_.variance[i] *= brightness * brightness;
    if (planes_.bias) planes_.bias[i] *= brightness;
  }

  /// What the air before the cloud leaves of its light, of red, green and blue: that of sunlight.
  Vec3 throughAir(const Vec3& toSky) const {
    const Vec3 left = toRec709_ * clouded_.fromCloud(toSky);
    Vec3 share(1.0);
    for (int c = 0; c < 3; ++c)
      if (sunlight_[c] > 0.0) share[c] = std::max(0.0, left[c] / sunlight_[c]);
    return share;
  }

  Vec3 behind(const Vec3& toSky, int x, int y) const {
    constexpr double kReach = 2.0;  // pixels, more than half of one's diagonal wherever lenses stretch them
    const bool isAtHorizon = std::abs(toSky.z - portable::sin(sky_.horizon())) * camera_.focalLength() < kReach;
    if (!isAtHorizon) return toRec709_ * clouded_.radiance(toSky);
    constexpr int kSamples = 4;
    return toRec709_ *
           meanOverPixel(camera_, x, y, kSamples, [&](const Vec3& there) { return clouded_.radiance(there); });
  }

  Image& image_;
  const Camera& camera_;
  const Scene& scene_;
  Planes planes_;
  AirSky sky_;
  Mat3 toRec709_;
  const SlabLight& slab_;  // in sunlight as it is above the air
  const Image* more_;
  CloudedSky clouded_;
  double illuminance_;  // of that, lx
  Mat3 fromHalo_;       // from the slab's light to Rec.709
  Vec3 sunlight_;       // at the cloud, Rec.709
};

}  // namespace

SunSettings sunAtCloud(const Scene& scene) {
  SunSettings sun = scene.sun;
  auto* light = std::get_if<ContinuousSpectrum>(&sun.spectrum);
  if (!scene.sky.air || !light) return sun;
  const Atmosphere air(scene.sky);
  std::vector<double> transmittance;
  double most = 0.0;
  const double altitude = cloudAltitudeOf(scene).value_or(altitudeOf(scene) + kEyeHeight);
  for (int i = 0; i < kVisibleNodes; ++i) {
    transmittance.push_back(air.sunTransmittance(kVisibleFirst + i, altitude, sun.elevation));
    most = std::max(most, transmittance.back());
  }
  if (most > 0.0) light->transmittance = std::move(transmittance);
  return sun;
}

void addAir(Image& image, const Camera& camera, const TallyInfo& info, const Scene& scene, int threads) {
  const SlabLight slab = withThreads(threads, [&] { return SlabLight(scene, info.undeviatedFraction()); });
  addAir(image, camera, info, scene, threads, slab, nullptr);
}

void addAir(Image& image, const Camera& camera, const TallyInfo& info, const Scene& scene, int threads,
            const SlabLight& slab, const Image* more) {
  withThreads(threads, [&] {
    Background background(image, camera, info, scene, slab, more);
    background.add();
    if (scene.sun.visible) background.drawTheSun();
    return true;
  });
}

}  // namespace parhelion
