// SPDX-License-Identifier: Apache-2.0
#include "render/integrated_sky.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "beam/sky_integral.h"
#include "beam/tilt_integral.h"
#include "crystal/population.h"
#include "optics/spectrum.h"
#include "optics/sun.h"
#include "picture/colour_space.h"
#include "render/prism_populations.h"
#include "render/traced_sky.h"
#include "sky/camera.h"
#include "sky/lens.h"
#include "sky/radial_sky.h"
#include "sky/radiance.h"

namespace parhelion {

namespace {

// Crystals of spread aspect ratios are as many.
constexpr int kPictureAspects = 8;
// Rings of randomly oriented crystals: so many to a pixel on the axis, within these bounds.
constexpr double kRingsPerPixel = 4.0;
constexpr int kFewestRings = 1440, kMostRings = 36000;
// Points of the sun's disc that rings are widened by: distances from its centre, and angles of half a turn about it.
constexpr int kDiscDistances = 12, kDiscAngles = 24;
// Rays whose light the tally of rings is given, for its whole numbers.
constexpr double kRays = 1e7;
// Beyond the farthest corner of a picture (rad).
constexpr double kMargin = 0.02;

/// A population's light in the pixels, over the surface of its crystals in units of mean shadows.
struct PopulationSky {
  std::vector<Tristimulus> light;
  std::vector<double> error;  // standard error of Y
  SheetTotals totals;
  double meshError = 0.0;
  long directions = 0, sheets = 0;
  bool reached = true;
};

/// Light by rings.
struct Rings {
  std::vector<Tristimulus> light;
  std::vector<double> error;
};

/// Rings about the sun's centre, of rings about each of its points.
Rings widened(const Rings& rings, const Sun& sun) {
  if (sun.isPoint()) return rings;
  const SunDisc disc = sun.disc();
  const auto bins = static_cast<int>(rings.light.size());
  const double width = kPi / bins;
  Rings result{std::vector<Tristimulus>(rings.light.size()), std::vector<double>(rings.light.size())};
  for (int i = 0; i < kDiscDistances; ++i) {
    const double r = std::asin(disc.radius.at((i + 0.5) / kDiscDistances) * disc.sinRadius);
    const double sinR = std::sin(r), cosR = std::cos(r);
    for (int j = 0; j < kDiscAngles; ++j) {
      const double turn = std::cos((j + 0.5) * kPi / kDiscAngles), part = 1.0 / (kDiscDistances * kDiscAngles);
      for (int bin = 0; bin < bins; ++bin) {
        const double angle = (bin + 0.5) * width, s = std::sin(angle), c = std::cos(angle);
        const double onto = c * cosR - s * sinR * turn, across = s * cosR + c * sinR * turn,
                     rest = sinR * std::sqrt(1.0 - turn * turn);
        const double place = std::atan2(std::hypot(across, rest), onto) / width - 0.5;
        const double before = std::floor(place), t = place - before;
        for (const int step : {0, 1}) {
          const int to = std::clamp(static_cast<int>(before) + step, 0, bins - 1);
          const double share = part * (step ? t : 1.0 - t);
          const auto from = static_cast<std::size_t>(bin), into = static_cast<std::size_t>(to);
          for (std::size_t k = 0; k < 3; ++k) result.light[into][k] += share * rings.light[from][k];
          result.error[into] += share * rings.error[from];
        }
      }
    }
  }
  return result;
}

/// The light of rings in the pixels.
std::vector<Tristimulus> spread(const std::vector<Tristimulus>& rings, const TallyInfo& about, int colours) {
  TallyInfo info = about;
  info.rays = {{0, static_cast<std::uint64_t>(kRays)}};
  RadialSky radial(info, info.toSun(), colours);
  // Up to the edges of rings: light is even within each of those that it is given in.
  const auto bins = static_cast<double>(rings.size());
  std::vector<Tristimulus> light(rings.size() + 1);
  for (std::size_t k = 0; k < rings.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) light[k + 1][c] = light[k][c] + rings[k][c];
  const auto upTo = [&](double angle, const auto& value) {
    const double place = std::clamp(angle / kPi * bins, 0.0, bins);
    const auto cell = std::min(static_cast<std::size_t>(place), rings.size() - 1);
    const double t = place - static_cast<double>(cell);
    return (1.0 - t) * value(cell) + t * value(cell + 1);
  };
  const int count = radial.bins();
  const auto edge = [&](int ring) {
    const double chord = 2.0 * std::sqrt(2.0) * std::min(ring, count - ring) / count;
    const double angle = 2.0 * std::asin(0.5 * chord);
    return 2 * ring <= count ? angle : kPi - angle;
  };
  const Vec3& white = info.white;
  for (int ring = 0; ring < count; ++ring) {
    const double from = edge(ring), to = edge(ring + 1);
    const auto within = [&](const auto& value) { return upTo(to, value) - upTo(from, value); };
    const auto colour = [&](std::size_t c) { return kRays * within([&](std::size_t k) { return light[k][c]; }); };
    const double y = colour(1);
    radial.setRaw(ring, TallySlots::kY, toFixed(y));
    radial.setRaw(ring, TallySlots::kFirstHalf, toFixed(0.5 * y));
    radial.setRaw(ring, TallySlots::kHits, y > 0.0 ? 1 : 0);
    if (colours == 1) continue;
    radial.setRaw(ring, TallySlots::kX, toFixed(white.x > 0.0 ? colour(0) / white.x : 0.0));
    radial.setRaw(ring, TallySlots::kZ, toFixed(white.z > 0.0 ? colour(2) / white.z : 0.0));
  }
  Tally tally(info, colours);
  radial.spreadOver(tally);
  std::vector<Tristimulus> pixels;
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
    const Vec3 xyz = colours == 1 ? Vec3(tally.luminance(pixel)) : tally.xyz(pixel);
    pixels.push_back({xyz.x / kRays, xyz.y / kRays, xyz.z / kRays});
  }
  return pixels;
}

/// Cosine of the largest angle from the camera's axis that its picture shows; -2 where there is none.
double widestOf(const Camera& camera) {
  if (isPanorama(camera.settings().projection) || camera.seam() > 0.0) return -2.0;
  const auto corner = camera.directionAt(camera.farthestCorner());
  if (!corner) return -2.0;
  const Triple<double> forward = camera.lens().forward;
  const double cosine = forward.x * corner->x + forward.y * corner->y + forward.z * corner->z;
  return std::cos(std::min(std::acos(std::clamp(cosine, -1.0, 1.0)) + kMargin, kPi));
}

class Sky {
 public:
  Sky(const LoadedScene& loaded, double error, LightStore& store)
      : scene_(loaded.scene), error_(error), store_(store), camera_(scene_.camera), sun_(scene_.sun), indices_(scene_) {
    const Spectrum spectrum(scene_.sun.spectrum);
    colours_ = spectrum.colours();
    result_.info = skyInfoOf(loaded);
  }

  IntegratedSky run() {
    double all = 0.0;
    for (const PopulationSettings& population : scene_.populations) all += population.weight;
    const auto pixels = static_cast<std::size_t>(camera_.width()) * static_cast<std::size_t>(camera_.height());
    std::vector<Tristimulus> sum(pixels);
    std::vector<double> squares(pixels);
    std::vector<std::vector<Tristimulus>> layers(layerNames().size(), std::vector<Tristimulus>(pixels));
    SheetTotals totals;
    for (const PopulationSettings& population : scene_.populations) {
      if (population.weight == 0.0) continue;
      const double weight = population.weight / all;
      const PopulationSky sky = std::holds_alternative<RandomOrientation>(population.orientation)
                                    ? randomSky(population)
                                    : axisSky(population);
      totals.add(sky.totals, weight);
      const auto addTo = [&](std::vector<Tristimulus>& light) {
        for (std::size_t i = 0; i < pixels; ++i)
          for (std::size_t c = 0; c < 3; ++c) light[i][c] += weight * sky.light[i][c];
      };
      addTo(sum);
      if (!layers.empty()) addTo(layers[layerOf(population.name)]);
      for (std::size_t i = 0; i < pixels; ++i) squares[i] += weight * weight * sky.error[i] * sky.error[i];
      result_.directions += sky.directions;
      result_.sheets += sky.sheets;
      result_.reached = result_.reached && sky.reached;
    }
    makeImage(sum, squares, layers, totals);
    return std::move(result_);
  }

 private:
  std::vector<std::string> layerNames() const {
    std::vector<std::string> names;
    for (const LayerSettings& layer : scene_.trace.paths.layers) names.push_back(layer.name);
    if (!names.empty()) names.emplace_back(kRestLayer);
    return names;
  }

  std::size_t layerOf(const std::string& population) const {
    const auto& layers = scene_.trace.paths.layers;
    const auto takes = [&](const LayerSettings& layer) {
      return layer.populations.empty() || std::ranges::find(layer.populations, population) != layer.populations.end();
    };
    return static_cast<std::size_t>(std::ranges::find_if(layers, takes) - layers.begin());
  }

  PopulationSky randomSky(const PopulationSettings& population) {
    const int bins = static_cast<int>(
        std::clamp(kPi * kRingsPerPixel * camera_.focalLength(), double{kFewestRings}, double{kMostRings}));
    const RingIntegral integral = integrateRings(axisScene(population), accuracy(), bins, store_.rings);
    const Rings rings = widened({integral.light, integral.error}, sun_);
    PopulationSky sky;
    sky.light = spread(rings.light, result_.info, colours_);
    // Errors of neighbouring rings go together.
    std::vector<Tristimulus> errors;
    for (const double error : rings.error) errors.push_back({error, error, error});
    for (const Tristimulus& error : spread(errors, result_.info, 1)) sky.error.push_back(error[1]);
    sky.totals = integral.totals;
    sky.directions = integral.directions;
    sky.reached = integral.reached;
    return sky;
  }

  /// All of a population but its tilts.
  AxisScene axisScene(const PopulationSettings& settings) const {
    AxisScene axis;
    axis.prisms = prismsOf(settings, kPictureAspects);
    axis.indices = indices_.nodes();
    axis.toSun = [&](double u1, double u2) {
      if (sun_.isPoint()) return sun_.toCentre();
      const Triple<double> point = sun_.disc().toPoint(u1, u2);
      return Vec3(point.x, point.y, point.z);
    };
    axis.light = [&](double u) { return indices_.at(u); };
    axis.lines = indices_.lines();
    axis.sun = {sun_.toCentre(), 0.5 * sun_.diameter(), [&](double angle) { return sun_.radiance(angle); }};
    return axis;
  }

  SkyAccuracy accuracy() const {
    SkyAccuracy accuracy;
    accuracy.error = error_;
    accuracy.seed = scene_.trace.seed;
    accuracy.folds = camera_.isMirrorSymmetric() && sun_.toCentre().y == 0.0;
    accuracy.hasEdge = !isPanorama(camera_.settings().projection) && camera_.seam() == 0.0;
    accuracy.widest = widestOf(camera_);
    return accuracy;
  }

  PopulationSky axisSky(const PopulationSettings& settings) {
    const Population population(settings);
    const AngleQuantile& zenith = population.orientationQuantile().zenith;
    AxisScene axis = axisScene(settings);
    axis.tilt = [&](double u) { return zenith.at(u); };
    axis.oneTilt = zenith.kind == AngleQuantile::Kind::linear && zenith.width == 0.0;
    const SkyIntegral integral = integrateSky(axis, accuracy(), camera_, store_.bands);
    PopulationSky sky;
    for (std::size_t i = 0; i < integral.xyz.size(); ++i) {
      const auto& xyz = integral.xyz[i];
      sky.light.push_back({static_cast<double>(xyz[0]), static_cast<double>(xyz[1]), static_cast<double>(xyz[2])});
      sky.error.push_back(std::sqrt(static_cast<double>(integral.variance[i])));
    }
    sky.totals = integral.totals;
    sky.directions = integral.directions;
    sky.sheets = integral.sheets;
    sky.reached = integral.reached;
    return sky;
  }

  void makeImage(const std::vector<Tristimulus>& sum, const std::vector<double>& squares,
                 const std::vector<std::vector<Tristimulus>>& layers, const SheetTotals& totals) {
    Image& image = result_.image;
    image = {camera_.width(), camera_.height(), {}};
    const std::vector<double> solidAngles = camera_.solidAngles();
    const Mat3 toRgb = xyzToRec709(result_.info.white);
    const auto add = [&](const std::vector<Tristimulus>& light, const std::string& before) {
      for (const char* name : {"R", "G", "B"}) image.add(before + name);
      const std::size_t first = image.channels.size() - 3;
      for (std::size_t i = 0; i < light.size(); ++i) {
        if (solidAngles[i] <= 0.0) continue;
        const Vec3 xyz = Vec3(light[i][0], light[i][1], light[i][2]) / (totals.intercepted * solidAngles[i]);
        const Vec3 rgb = colours_ == 1 ? Vec3(xyz.y) : toRgb * xyz;
        for (int c = 0; c < 3; ++c)
          image.channels[first + static_cast<std::size_t>(c)].samples[i] = static_cast<float>(rgb[c]);
      }
    };
    add(sum, "");
    image.add(kVarianceChannel);
    std::vector<float>& variance = image.channels.back().samples;
    double errors = 0.0, light = 0.0;
    for (std::size_t i = 0; i < squares.size(); ++i) {
      if (solidAngles[i] <= 0.0) continue;
      const double per = 1.0 / (totals.intercepted * solidAngles[i]);
      variance[i] = static_cast<float>(per * per * squares[i]);
      errors += std::sqrt(squares[i]);
      light += sum[i][1];
    }
    const std::vector<std::string> names = layerNames();
    for (std::size_t k = 0; k < names.size(); ++k) add(layers[k], names[k] + ".");
    result_.error = light > 0.0 ? errors / light : 0.0;
    result_.cutOff = totals.cutOff / totals.intercepted;
    result_.info.intercepted.add(1.0);
    result_.info.undeviated.add(totals.undeviated / totals.intercepted);
  }

  const Scene& scene_;
  double error_;
  LightStore& store_;
  Camera camera_;
  Sun sun_;
  IndexSampler indices_;
  int colours_ = 3;
  IntegratedSky result_;
};

}  // namespace

std::string objectionToIntegratedSky(const Scene& scene) {
  if (scene.trace.paths.filter) return "light is filtered by its raypaths";
  for (const LayerSettings& layer : scene.trace.paths.layers)
    if (layer.paths || layer.tilt) return "layer " + layer.name + " tells light apart by more than its population";
  for (const PopulationSettings& population : scene.populations)
    if (const std::string objection = objectionTo(population, false); !objection.empty())
      return "population " + population.name + " " + objection;
  return {};
}

std::uint64_t memoryOfOrientations(const Scene& scene, double error) {
  const auto isTilted = [](const PopulationSettings& one) {
    return !std::holds_alternative<RandomOrientation>(one.orientation);
  };
  if (std::ranges::none_of(scene.populations, isTilted)) return 0;
  return memoryForTilts(Camera(scene.camera), 0.5 * Sun(scene.sun).diameter(), error);
}

IntegratedSky integrateSky(const LoadedScene& loaded, double error, LightStore* store) {
  if (const std::string objection = objectionToIntegratedSky(loaded.scene); !objection.empty())
    throw std::invalid_argument(objection);
  LightStore none;
  if (!store) store = &none;
  store->bands.startPicture();
  return Sky(loaded, error, *store).run();
}

}  // namespace parhelion
