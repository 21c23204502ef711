// SPDX-License-Identifier: Apache-2.0
#include "trace/extinction.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <variant>

#include "crystal/entry.h"
#include "math/arctangent.h"
#include "math/rotation.h"
#include "parallel/loops.h"
#include "trace/drawn_crystal.h"
#include "trace/scatter_profile.h"
#include "trace/silhouettes.h"
#include "trace/trace.h"

namespace parhelion {

namespace {

// Elevations, closer toward the horizon, and azimuths where these matter.
constexpr int kShadowRows = 31, kUndeviatedRows = 13, kAzimuths = 24;
// For each direction: crystals whose shadows are measured, and rays that show what passes undeviated.
constexpr int kCrystals = 4096;
constexpr std::uint64_t kRays = 32768, kRaysOfOne = 131072;

bool hasFreeAzimuths(const PopulationSettings& population) {
  const auto* axis = std::get_if<AxisOrientation>(&population.orientation);
  return !axis || isFree(axis->azimuth, 2.0 * kPi);
}

/// The shadows of a crystal, at any stretch.
class CrystalShadow {
 public:
  explicit CrystalShadow(const CrystalMesh& mesh) : faces_(mesh) {
    if (!mesh.isConvex()) silhouettes_.emplace(mesh);
  }

  /// On light of a direction (unit, crystal frame), over the crystal's surface.
  double at(double stretch, const Triple<double>& light) const {
    if (silhouettes_) return silhouettes_->at({light.x, light.y, light.z});
    return castShadows(faces_, stretch, light).total / (faces_.surfaceAcrossC + faces_.surfaceAlongC * stretch);
  }

  /// The mean over all directions.
  double mean() const { return silhouettes_ ? silhouettes_->mean() : kRandomShadow; }

 private:
  FaceTable faces_;
  std::optional<Silhouettes> silhouettes_;  // of crystals that are not convex
};

/// A population's crystal; where shapes are spread, so many that they stand for all.
std::vector<CrystalShadow> shapesOf(const Population& population) {
  constexpr std::uint64_t kShapes = 61;
  std::vector<CrystalShadow> shapes;
  if (!population.isSpread()) shapes.emplace_back(population.mesh());
  for (std::uint64_t k = 0; population.isSpread() && k < kShapes; ++k)
    shapes.emplace_back(DrawnCrystal(population, 0, k).mesh);
  return shapes;
}

/// The mean shadow of crystals in any orientation, per surface.
double meanShadow(std::span<const CrystalShadow> shapes) {
  double sum = 0.0;
  for (const CrystalShadow& shape : shapes) sum += shape.mean();
  return sum / static_cast<double>(shapes.size());
}

/// The mean shadow of crystals per surface, by points that fill the unit cube evenly: an additive recurrence with the
/// roots of x^5 = x + 1 (Roberts 2018).
double meanShadow(const Population& population, std::span<const CrystalShadow> shapes, const Vec3& toLight) {
  constexpr double kRoot = 1.1673039782614187;
  double step[4], power = 1.0;
  for (double& s : step) s = power /= kRoot;
  double sum = 0.0;
  for (int k = 1; k <= kCrystals; ++k) {
    double u[4];
    for (int d = 0; d < 4; ++d) {
      const double place = 0.5 + k * step[d];
      u[d] = std::clamp(place - std::floor(place), 1e-9, 1.0 - 1e-9);
    }
    const CrystalShadow& shape = shapes[static_cast<std::size_t>(k) % shapes.size()];
    const auto axes = population.orientationQuantile().at(u[0], u[1], u[2]);
    const double stretch = population.stretch() ? population.stretch()->at(u[3]) : 1.0;
    const auto along = [&](const Triple<double>& axis) {
      return -(axis.x * toLight.x + axis.y * toLight.y + axis.z * toLight.z);
    };
    const Triple<double> light{along(axes.x), along(axes.y), along(axes.z)};
    sum += shape.at(stretch, light);
  }
  return sum / kCrystals;
}

double undeviatedIn(const Cloud& cloud, std::uint64_t rays) {
  TraceSettings settings;
  settings.rays = rays;
  settings.sampler = Sampler::sobol;
  ScatterProfile profile(1, 0.0, kPi);
  TraceControl alone;
  alone.threads = 1;
  traceRays(cloud, settings, 0, profile, alone);
  return profile.summary().undeviated;
}

}  // namespace

Vec3 Extinction::Table::directionOf(std::size_t k) const {
  const auto columns = static_cast<std::size_t>(columns_);
  const double row = rows_ > 1 ? static_cast<double>(k / columns) / (rows_ - 1) : 1.0;
  return skyDirection(2.0 * kPi * static_cast<double>(k % columns) / columns_, 0.5 * kPi * row * row);
}

double Extinction::Table::at(const Place& place) const {
  if (rows_ == 1) return numbers_.front();
  const double y = place.root * (rows_ - 1);
  const int row = std::min(static_cast<int>(y), rows_ - 2);
  const auto between = [](double a, double b, double t) { return a + t * (b - a); };
  if (columns_ == 1) return between(node(row, 0), node(row + 1, 0), y - row);
  const double x = place.turns * columns_;
  const int column = std::min(static_cast<int>(x), columns_ - 1);
  return between(between(node(row, column), node(row, column + 1), x - column),
                 between(node(row + 1, column), node(row + 1, column + 1), x - column), y - row);
}

Extinction::Kind Extinction::kindOf(const SunSettings& sun, const IceSettings& ice,
                                    std::span<const PopulationSettings> populations, std::size_t number) {
  const PopulationSettings& settings = populations[number];
  const Population population(settings);
  const std::vector<CrystalShadow> shapes = shapesOf(population);
  const int columns = hasFreeAzimuths(settings) ? 1 : kAzimuths;
  const bool isRandom = population.isFullyRandom();
  Kind kind{
      number, population.weight(), {isRandom ? 1 : kShadowRows, columns}, {isRandom ? 1 : kUndeviatedRows, columns}};
  if (isRandom) kind.shadow[0] = meanShadow(shapes);
  if (!isRandom)
    forEach(kind.shadow.size(),
            [&](std::size_t k) { kind.shadow[k] = meanShadow(population, shapes, kind.shadow.directionOf(k)); });
  forEach(kind.undeviated.size(), [&](std::size_t k) {
    const SkyPoint from = skyPoint(kind.undeviated.directionOf(k));
    SunSettings light = sun;
    light.diameter = 0.0;
    light.elevation = from.elevation;
    PopulationSettings turned = settings;
    turned.weight = 1.0;
    if (auto* axis = std::get_if<AxisOrientation>(&turned.orientation); axis && columns > 1)
      axis->azimuth = shifted(axis->azimuth, -from.azimuth);
    kind.undeviated[k] = undeviatedIn(Cloud(light, ice, std::span(&turned, 1)), isRandom ? kRaysOfOne : kRays);
  });
  return kind;
}

Extinction::Extinction(const SunSettings& sun, const IceSettings& ice, std::span<const PopulationSettings> populations,
                       std::span<const HazeSettings> hazes) {
  for (std::size_t p = 0; p < populations.size(); ++p)
    if (populations[p].weight > 0.0) kinds_.push_back(kindOf(sun, ice, populations, p));
  for (const HazeSettings& haze : hazes) hazes_.push_back(haze.weight * kRandomShadow);
  sumUp();
}

void Extinction::sumUp() {
  haze_ = 0.0;
  for (const double haze : hazes_) haze_ += haze;
  if (kinds_.empty() && !(haze_ > 0.0)) throw std::invalid_argument("no population has any weight");
  zenith_ = 1.0;
  zenith_ = at(Vec3(0.0, 0.0, 1.0)).shadow;
}

Extinction Extinction::part(std::span<const std::size_t> populations, std::span<const std::size_t> hazes) const {
  Extinction some = *this;
  std::erase_if(some.kinds_,
                [&](const Kind& kind) { return std::ranges::find(populations, kind.population) == populations.end(); });
  for (std::size_t h = 0; h < some.hazes_.size(); ++h)
    if (std::ranges::find(hazes, h) == hazes.end()) some.hazes_[h] = 0.0;
  some.sumUp();
  return some;
}

bool Extinction::isSameAllAround() const {
  return std::ranges::all_of(kinds_, [](const Kind& kind) { return kind.shadow.isSameAllAround(); });
}

Extinction::Crystals Extinction::at(const Vec3& toLight) const {
  const Vec3 up = toLight.z < 0.0 ? -toLight : toLight;
  const double elevation = arctangent(up.z, std::sqrt(up.x * up.x + up.y * up.y)) / (0.5 * kPi),
               turns = arctangent(-up.y, up.x) / (2.0 * kPi);
  const Place place{std::sqrt(std::clamp(elevation, 0.0, 1.0)), turns - std::floor(turns)};
  Crystals all{haze_, 0.0};
  for (const Kind& kind : kinds_) {
    const double shadow = kind.weight * kind.shadow.at(place);
    all.shadow += shadow;
    all.undeviated += shadow * kind.undeviated.at(place);
  }
  return {all.shadow / zenith_, all.undeviated / all.shadow, haze_ / all.shadow};
}

}  // namespace parhelion
