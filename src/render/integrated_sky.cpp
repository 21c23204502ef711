// SPDX-License-Identifier: Apache-2.0
#include "render/integrated_sky.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "beam/azimuth_integral.h"
#include "beam/sky_integral.h"
#include "beam/tilt_integral.h"
#include "crystal/population.h"
#include "crystal/symmetry.h"
#include "optics/spectrum.h"
#include "optics/sun.h"
#include "picture/colour_space.h"
#include "render/light_parts.h"
#include "render/prism_populations.h"
#include "render/ring_picture.h"
#include "render/traced_sky.h"
#include "sky/camera.h"
#include "sky/lens.h"
#include "sky/radiance.h"

namespace parhelion {

namespace {

// Rings of randomly oriented crystals: so many to a pixel on the axis, within these bounds. Light of some raypaths ends
// more sharply than all of it.
constexpr double kRingsPerPixel = 4.0;
constexpr int kFewestRings = 1440, kFewestOfPaths = 7200, kMostRings = 36000;
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
  Sky(const LoadedScene& loaded, double error, LightStore& store, Counted counted,
      const std::function<bool(double)>& goOn)
      : scene_(loaded.scene),
        error_(error),
        store_(store),
        camera_(scene_.camera),
        sun_(scene_.sun),
        indices_(scene_, counted),
        goOn_(goOn) {
    if (counted == Counted::energy)
      colours_ = 1;
    else
      colours_ = Spectrum(scene_.sun.spectrum).colours();
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
    const std::vector<LightParts> parts = lightPartsOf(scene_);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const PopulationSettings& population = scene_.populations[k];
      if (population.weight == 0.0) continue;
      const double weight = population.weight / all;
      std::vector<double> errors(pixels);
      for (const LightPart& part : parts[k]) {
        PopulationSky sky = skyOf(population, part);
        if (result_.refused) return std::move(result_);
        // Crystals intercept the same light in each of their parts.
        if (&part != &parts[k].front()) sky.totals.intercepted = 0.0;
        totals.add(sky.totals, weight);
        const auto addTo = [&](std::vector<Tristimulus>& light) {
          for (std::size_t i = 0; i < pixels; ++i)
            for (std::size_t c = 0; c < 3; ++c) light[i][c] += weight * sky.light[i][c];
        };
        addTo(sum);
        if (!layers.empty()) addTo(layers[part.layer]);
        for (std::size_t i = 0; i < pixels; ++i) errors[i] += sky.error[i];
      }
      for (std::size_t i = 0; i < pixels; ++i) squares[i] += weight * weight * errors[i] * errors[i];
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

  /// Whether crystals and their mirror images in the sun's vertical plane do the same to light that is wanted.
  static bool isMirrored(const AxisScene& axis, const WantedPaths& wanted) {
    const bool hasSidesAlike = std::abs(axis.rest->y.y) > 1.0 - kAngleSlack;
    return hasSidesAlike && wanted.areAlikeMirrored();
  }

  /// Part of a population's light. What crystals do that stand on their heads is another thing where paths tell their
  /// ends apart.
  PopulationSky skyOf(const PopulationSettings& population, const LightPart& part) {
    AxisScene axis = axisScene(population);
    if (axis.rest) axis.isMirrored = isMirrorSymmetric(population) && (!part.wanted || isMirrored(axis, *part.wanted));
    if (!part.wanted) return skyOf(population, axis);
    axis.wanted = &*part.wanted;
    if (axis.rest || part.wanted->areAlikeUpsideDown()) return skyOf(population, axis);
    const WantedPaths below = part.wanted->upsideDown();
    axis.side = CrystalSide::upper;
    PopulationSky sky = skyOf(population, axis);
    axis.side = CrystalSide::lower;
    axis.wanted = &below;
    const PopulationSky other = skyOf(population, axis);
    if (result_.refused) return sky;
    for (std::size_t i = 0; i < sky.light.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) sky.light[i][c] += other.light[i][c];
      sky.error[i] += other.error[i];
    }
    sky.totals.add(other.totals, 1.0);
    return sky;
  }

  PopulationSky skyOf(const PopulationSettings& population, const AxisScene& axis) {
    const bool isRandom = std::holds_alternative<RandomOrientation>(population.orientation);
    PopulationSky sky = isRandom ? randomSky(axis) : axisSky(axis);
    result_.directions += sky.directions;
    result_.sheets += sky.sheets;
    result_.reached = result_.reached && sky.reached;
    return sky;
  }

  PopulationSky randomSky(const AxisScene& axis) {
    const double fewest = axis.wanted ? kFewestOfPaths : kFewestRings;
    const int bins =
        static_cast<int>(std::clamp(kPi * kRingsPerPixel * camera_.focalLength(), fewest, double{kMostRings}));
    const RingIntegral integral = integrateRings(axis, accuracy(axis), bins, store_.rings);
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

  AxisScene axisScene(const PopulationSettings& settings) const {
    AxisScene axis;
    axis.prisms = prismsOf(settings, aspectsFor(error_));
    axis.indices = indices_.nodes();
    axis.toSun = [&](double u1, double u2) {
      if (sun_.isPoint()) return sun_.toCentre();
      const Triple<double> point = sun_.disc().toPoint(u1, u2);
      return Vec3(point.x, point.y, point.z);
    };
    axis.light = [&](double u) { return indices_.at(u); };
    axis.lines = indices_.lines();
    axis.sun = {sun_.toCentre(), 0.5 * sun_.diameter(), [&](double angle) { return sun_.radiance(angle); }};
    if (std::holds_alternative<RandomOrientation>(settings.orientation)) return axis;
    axis.rest = standingOf(settings.orientation);
    if (axis.rest) return axis;
    const auto population = std::make_shared<Population>(settings);  // which has the table of tilts
    const AngleQuantile& zenith = population->orientationQuantile().zenith;
    axis.tilt = [population, &zenith](double u) { return zenith.at(u); };
    axis.oneTilt = zenith.kind == AngleQuantile::Kind::linear && zenith.width == 0.0;
    return axis;
  }

  SkyAccuracy accuracy(const AxisScene& axis) const {
    SkyAccuracy accuracy;
    const bool isDark = axis.wanted && axis.wanted->isNothing();
    accuracy.error = isDark ? 1.0 : error_;
    accuracy.seed = scene_.trace.seed;
    accuracy.folds = camera_.isMirrorSymmetric() && sun_.toCentre().y == 0.0 && axis.isMirrored;
    accuracy.hasEdge = !isPanorama(camera_.settings().projection) && camera_.seam() == 0.0;
    accuracy.widest = widestOf(camera_);
    accuracy.goOn = goOn_;
    return accuracy;
  }

  PopulationSky axisSky(const AxisScene& axis) {
    const SkyIntegral integral = integrateSky(axis, accuracy(axis), camera_, store_.bands);
    result_.refused = result_.refused || integral.refused;
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
    const std::vector<double> solidAngles = store_.bands.solidAngles(camera_);
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
  std::function<bool(double)> goOn_;
  int colours_ = 3;
  IntegratedSky result_;
};

}  // namespace

std::string objectionToIntegratedSky(const Scene& scene) {
  const std::vector<std::string> objections = objectionsToIntegrating(scene);
  for (std::size_t k = 0; k < objections.size(); ++k)
    if (!objections[k].empty()) return "population " + scene.populations[k].name + " " + objections[k];
  return {};
}

std::uint64_t memoryOfOrientations(const Scene& scene, double error) {
  const double radius = 0.5 * Sun(scene.sun).diameter();
  std::uint64_t most = 0;
  for (const PopulationSettings& one : scene.populations) {
    if (std::holds_alternative<RandomOrientation>(one.orientation)) continue;
    const bool isAtRest = standingOf(one.orientation).has_value();
    most = std::max(most,
                    isAtRest ? memoryForAzimuths(radius, error) : memoryForTilts(Camera(scene.camera), radius, error));
  }
  return most;
}

IntegratedSky integrateSky(const LoadedScene& loaded, double error, LightStore* store, Counted counted,
                           const std::function<bool(double)>& goOn) {
  if (const std::string objection = objectionToIntegratedSky(loaded.scene); !objection.empty())
    throw std::invalid_argument(objection);
  LightStore none;
  if (!store) store = &none;
  store->bands.startPicture();
  return Sky(loaded, error, *store, counted, goOn).run();
}

}  // namespace parhelion
