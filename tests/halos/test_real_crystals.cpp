// SPDX-License-Identifier: Apache-2.0
// Crystals that absorb, whose faces are tilted, and whose faces spread light.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "crystal/span.h"
#include "halos/closed_forms.h"
#include "halos/experiment.h"
#include "trace/scatter_profile.h"

using namespace parhelion;

namespace {

constexpr double kWavelength = 550.0;  // nm

IceSettings absorbing(double k, double index = kIndex) {
  IceSettings ice = ConstantIndex{index};
  ice.absorbs = true;
  ice.k = k;
  return ice;
}

PopulationSettings sized(PopulationSettings population, double micrometres) {
  population.size = FixedValue{micrometres};
  return population;
}

PopulationSettings distorted(PopulationSettings population, double degrees) {
  population.distortion = radians(degrees);
  return population;
}

PopulationSettings diffracting(PopulationSettings population, double micrometres) {
  population.diffracts = true;
  return sized(std::move(population), micrometres);
}

PopulationSettings hollowColumns() {
  PrismSettings prism{FixedValue{2.0}};
  prism.upper.cavity = prism.lower.cavity = {0.4, 0.8};
  return {"hollow", 1.0, prism, RandomOrientation{}};
}

/// All that is not ideal, at once.
PopulationSettings worn(PopulationSettings population) {
  return distorted(diffracting(std::move(population), 40.0), 3.0);
}

double outOf(const LightPath& path) {
  double out = path.cutOff + path.lost + path.absorbed;
  for (const Exit& exit : path.exits) out += exit.energy;
  return out;
}

/// Light of crystals whose faces are mirrors for it, at the outside of a basal face.
template <class Look>
void forReflections(const Cloud& cloud, std::uint64_t rays, Look&& look) {
  forEachRay(cloud, rays, [&](const LightPath& path) {
    const int face = path.incident.entry.face;
    if (!isBasal(path.incident.crystal.mesh->faces()[face].number)) return;
    const Vec3 n = path.incident.crystal.mesh->faces()[face].normal, in = path.incident.lightDirCrystal;
    for (const Exit& exit : path.exits)
      if (exit.order == 0)
        look(path, in - 2.0 * glm::dot(in, n) * n, glm::transpose(path.incident.crystalToWorld) * exit.lightDirWorld);
  });
}

/// Integral of (sin(pi x) / pi x)^2 from -x to x.
double shareWithin(double x) {
  constexpr int kSteps = 20'000;
  double sum = 0.0;
  for (int k = 0; k < kSteps; ++k) {
    const double at = x * (k + 0.5) / kSteps, amplitude = std::sin(kPi * at) / (kPi * at);
    sum += 2.0 * x / kSteps * amplitude * amplitude;
  }
  return sum;
}

}  // namespace

TEST_CASE("a plate that light falls on squarely lets through and throws back what a slab does that absorbs") {
  constexpr double kSize = 1000.0, kAspect = 0.01, kImaginary = 0.005;
  // The longest way between corners is over both diameters of the hexagon and the thickness.
  const double thickness = kSize * 2.0 * kAspect / std::hypot(2.0, 2.0 * kAspect);
  const double left = std::exp(-4.0 * kPi * kImaginary / (1e-3 * kWavelength) * thickness);
  const double r = std::pow((kIndex - 1.0) / (kIndex + 1.0), 2);
  const double through = (1.0 - r) * (1.0 - r) * left / (1.0 - r * r * left * left);
  const double back = r + r * (1.0 - r) * (1.0 - r) * left * left / (1.0 - r * r * left * left);
  CHECK(left > 0.2);
  CHECK(left < 0.5);
  const Cloud cloud = cloudUnderPointSun(radians(90), {sized(prisms(kAspect, plateOrientation()), kSize)},
                                         absorbing(kImaginary), kWavelength);
  for (const Engine engine : {Engine::planes, Engine::embree}) {
    SampleMean down, up, absorbed;
    forEachRay(cloud, 60'000,
               [&](const LightPath& path) {
                 double one = 0.0, other = 0.0;
                 for (const Exit& exit : path.exits) (exit.lightDirWorld.z < 0.0 ? one : other) += exit.energy;
                 down.add(one);
                 up.add(other);
                 absorbed.add(path.absorbed);
               },
               {.engine = engine});
    CHECK(down.sigmasFrom(through) < 4.0);
    CHECK(up.sigmasFrom(back) < 4.0);
    CHECK(absorbed.sigmasFrom(1.0 - through - back) < 4.0);
    CHECK(absorbed.standardError() < 0.002);
  }
  ScatterProfile profile(18, 0.0, kPi);
  const TraceReport report = traceRays(cloud, {.rays = 200'000}, 0, profile);
  CHECK(std::abs(report.energy.absorbed.value() / report.energy.in.value() - (1.0 - through - back)) < 0.002);
}

TEST_CASE("weak absorption takes 4 pi k / wavelength of the mean path n^2 4 V / S") {
  constexpr double kSize = 500.0, kImaginary = 1e-7, kAspect = 1.0;
  const Cloud cloud = cloudUnderPointSun(radians(20), {sized(prisms(kAspect, RandomOrientation{}), kSize)},
                                         absorbing(kImaginary), kWavelength);
  SampleMean absorbed;
  forEachRay(cloud, 400'000, [&](const LightPath& path) { absorbed.add(path.absorbed / path.incident.weight); });
  const double volume = 3.0 * std::sqrt(3.0) * kAspect, surface = 12.0 * kAspect + 3.0 * std::sqrt(3.0);
  const double unit = kSize / std::hypot(2.0, 2.0 * kAspect);  // um
  const double expected =
      4.0 * kPi * kImaginary / (1e-3 * kWavelength) * unit * kIndex * kIndex * 4.0 * volume / surface;
  CHECK(absorbed.sigmasFrom(expected) < 4.0);
  CHECK(absorbed.standardError() < 0.003 * expected);
}

TEST_CASE("what a crystal takes of a ray is its absorption times the way that the light has gone in it") {
  for (const PopulationSettings& kind : {prisms(0.3, RandomOrientation{}), hollowColumns()}) {
    const Cloud cloud = cloudUnderPointSun(radians(20), {sized(kind, 300.0)}, absorbing(2e-4), kWavelength);
    double worst = 0.0, sum = 0.0;
    forEachRay(cloud, 30'000, [&](const LightPath& path) {
      worst = std::max(worst, std::abs(path.absorbed - path.incident.absorption * path.internalPath));
      worst = std::max(worst, std::abs(outOf(path) - path.incident.weight));
      sum += path.absorbed;
    });
    CHECK(sum > 1000.0);
    CHECK(worst < 1e-9);
  }
}

TEST_CASE("without k crystals that absorb are ideal ones, ray by ray") {
  const PopulationSettings columns = prisms(2.0, RandomOrientation{});
  std::vector<double> ideal, other;
  const auto gather = [](const Cloud& cloud, std::vector<double>& energies) {
    forEachRay(cloud, 3'000, [&](const LightPath& path) {
      for (const Exit& exit : path.exits) energies.push_back(exit.energy);
    });
  };
  gather(cloudUnderPointSun(radians(20), {columns}), ideal);
  gather(cloudUnderPointSun(radians(20), {sized(columns, 100.0)}, absorbing(0.0)), other);
  CHECK(ideal == other);
}

TEST_CASE("crystals so dark that nothing gets through leave what they reflect at the outside") {
  const Cloud cloud =
      cloudUnderPointSun(radians(20), {sized(prisms(1.0, RandomOrientation{}), 1e5)}, absorbing(0.1), kWavelength);
  ScatterProfile profile(36, 0.0, kPi);
  const TraceReport report = traceRays(cloud, {.rays = 400'000}, 0, profile);
  const double in = report.energy.in.value();
  CHECK(std::abs(report.energy.out.value() / in - theory::externalReflection(kIndex)) < 1e-3);
  CHECK(report.hits < 3 * report.rays);
}

TEST_CASE("many rays at a time are what single rays are, of all that is not ideal") {
  for (const PopulationSettings& kind :
       {prisms(0.3, RandomOrientation{}), prisms(3.0, RandomOrientation{}), hollowColumns()}) {
    const Cloud cloud = cloudUnderPointSun(radians(20), {worn(kind)}, absorbing(1e-4), kWavelength);
    ScatterProfile profile(36, 0.0, kPi);
    const TraceReport report = traceRays(cloud, {.rays = 20'000}, 0, profile);
    double inside = 0.0, absorbed = 0.0, in = 0.0;
    std::vector<double> bins(36, 0.0);
    forEachRay(cloud, 20'000, [&](const LightPath& path) {
      inside += path.internalPath;
      absorbed += path.absorbed;
      in += path.incident.weight;
      for (const Exit& exit : path.exits) {
        const double angle = degrees(angleBetween(path.incident.lightDirWorld, exit.lightDirWorld));
        bins[static_cast<std::size_t>(std::min(35.0, angle / 5.0))] += exit.energy;
      }
    });
    CHECK(report.energy.absorbed.value() == doctest::Approx(absorbed).epsilon(1e-9));
    CHECK(profile.summary().meanPath == doctest::Approx(inside / in).epsilon(1e-9));
    for (std::size_t k = 0; k < bins.size(); ++k) CHECK(std::abs(profile.bins()[k].energy - bins[k] / in) < 1e-6);
  }
}

TEST_CASE("no light is lost or made by absorption, tilted faces and diffraction, by any engine and rule") {
  for (const PathMode mode : {PathMode::split, PathMode::chance})
    for (const Engine engine : {Engine::automatic, Engine::embree})
      for (const PopulationSettings& kind :
           {worn(prisms(0.1, RandomOrientation{})), distorted(prisms(4.0, RandomOrientation{}), 10.0),
            diffracting(prisms(1.0, columnOrientation()), 10.0), worn(hollowColumns())}) {
        const Cloud cloud = cloudUnderPointSun(radians(20), {kind}, absorbing(1e-4), kWavelength);
        ScatterProfile profile(36, 0.0, kPi);
        const TraceReport report = traceRays(cloud, {.rays = 30'000, .engine = engine, .path = mode}, 0, profile);
        CHECK(std::abs(report.energy.imbalance()) < 1e-9);
        CHECK((report.energy.absorbed.value() > 0.0) == kind.size.has_value());
        CHECK(report.energy.lost.value() < 1e-6 * report.energy.in.value());
      }
}

TEST_CASE("light that a tilted face reflects turns by twice the tilt, across its plane by its cosine less") {
  constexpr double kTilt = 0.5;  // degrees
  const double elevation = radians(50);
  const Cloud cloud = cloudUnderPointSun(elevation, {distorted(prisms(0.05, plateOrientation()), kTilt)});
  SampleMean inPlane, across;
  forReflections(cloud, 200'000, [&](const LightPath& path, const Vec3& mirrored, const Vec3& found) {
    const Vec3 side = glm::normalize(glm::cross(path.incident.lightDirCrystal, mirrored));
    const Vec3 up = glm::cross(side, mirrored);
    const double a = glm::dot(found, up), b = glm::dot(found, side);
    inPlane.add(a * a);
    across.add(b * b);
  });
  const double square = std::pow(2.0 * radians(kTilt), 2);
  // Terms of the next order are about the square of the tilt, 1e-4 of this.
  CHECK(inPlane.sigmasFrom(square) < 4.0);
  CHECK(across.sigmasFrom(square * std::pow(std::sin(elevation), 2)) < 4.0);
}

TEST_CASE("tilted faces widen the edge of the 22 degree ring, and let no light go on undeviated") {
  const auto shareBefore = [](double tilt) {
    const Cloud cloud = cloudUnderPointSun(radians(20), {distorted(prisms(1.0, RandomOrientation{}), tilt)});
    double before = 0.0, undeviated = 0.0;
    forEachRay(cloud, 100'000, [&](const LightPath& path) {
      for (const Exit& exit : path.exits) {
        const double angle = degrees(angleBetween(path.incident.lightDirWorld, exit.lightDirWorld));
        if (angle > 18.0 && angle < 21.5 && exit.order == 1) before += exit.energy;
        if (exit.undeviated) undeviated += exit.energy;
      }
    });
    return std::pair(before, undeviated);
  };
  const auto [sharp, through] = shareBefore(0.0);
  const auto [soft, none] = shareBefore(1.0);
  CHECK(sharp == 0.0);
  CHECK(through > 0.0);
  CHECK(soft > 100.0);
  CHECK(none == 0.0);
}

TEST_CASE("a face spreads light as a slit of its width does: as much within each zero of the pattern") {
  // A hexagon of side 1 has second moments of 5/24 about its middle, as a square of side sqrt(2.5).
  constexpr double kSize = 30.0, kAspect = 0.2;
  const Cloud cloud = cloudUnderPointSun(radians(40), {diffracting(prisms(kAspect, plateOrientation()), kSize)},
                                         ConstantIndex{kIndex}, kWavelength);
  const double unit = kSize / std::hypot(2.0, 2.0 * kAspect), width = std::sqrt(2.5) * unit;  // um
  double within[4] = {}, count = 0.0;
  constexpr double kTo[] = {0.3, 0.5, 1.0, 2.0};
  forReflections(cloud, 200'000, [&](const LightPath&, const Vec3& mirrored, const Vec3& found) {
    const Vec3 turned = found / glm::dot(found, mirrored) - mirrored;
    ++count;
    for (int k = 0; k < 4; ++k)
      within[k] += std::abs(turned.x) * width / (1e-3 * kWavelength) < kTo[k];  // along a side, which is level
  });
  for (int k = 0; k < 4; ++k) {
    CAPTURE(kTo[k]);
    const double share = shareWithin(kTo[k]);
    CHECK(std::abs(within[k] / count - share) < 4.0 * std::sqrt(share * (1.0 - share) / count));
  }
  CHECK(shareWithin(1.0) == doctest::Approx(0.9028).epsilon(1e-3));
}

TEST_CASE("a face of 30 micrometres spreads light of 550 nm to the first zero at 1 degree") {
  const CrystalMesh mesh = meshOf(PrismSettings{FixedValue{1.0}});
  const auto side = std::ranges::find(mesh.faces(), 3, &Face::number) - mesh.faces().begin();
  const FaceRectangle face = rectangleOf(mesh, static_cast<int>(side));
  CHECK(glm::length(face.one) == doctest::Approx(1.0));
  CHECK(glm::length(face.other) == doctest::Approx(2.0));
  CHECK(std::abs(glm::dot(face.one, face.other)) < 1e-12);
  const double size = 30.0 * CrystalSpan(mesh).at(1.0);  // so that the face is 30 um wide
  CHECK(CrystalSpan(mesh).at(1.0) == doctest::Approx(std::hypot(2.0, 2.0)));
  const Cloud cloud =
      cloudUnderPointSun(0.0, {diffracting(prisms(1.0, plateOrientation()), size)}, ConstantIndex{kIndex}, kWavelength);
  double wave = 0.0;
  forEachRay(cloud, 1, [&](const LightPath& path) { wave = path.incident.wave; });
  CHECK(degrees(wave / glm::length(face.one)) == doctest::Approx(1.05).epsilon(1e-3));
}

TEST_CASE("sizes may be distributions, and crystals of spread shapes have a size, too") {
  PopulationSettings some = sized(prisms(1.0, RandomOrientation{}), 1.0);
  some.size = UniformRange{100.0, 300.0};
  const auto sizesOf = [](const Cloud& cloud) {
    SampleMean sizes;
    forEachRay(cloud, 20'000, [&](const LightPath& path) {
      const CrystalSpan span(*path.incident.crystal.mesh);
      sizes.add(1e-3 * path.incident.light.wavelength / path.incident.wave * span.at(path.incident.crystal.stretch));
    });
    return sizes;
  };
  const SampleMean sizes = sizesOf(cloudUnderPointSun(radians(20), {some}, absorbing(1e-6)));
  CHECK(sizes.sigmasFrom(200.0) < 4.0);
  CHECK(sizes.standardError() == doctest::Approx(200.0 / std::sqrt(12.0 * 20'000)).epsilon(0.05));

  PrismSettings any{UniformRange{0.2, 2.0}};
  any.spreads = {{ShapeLength::sides, {true, false, true, false, true, false}, UniformRange{0.7, 1.3}}};
  const SampleMean fixed =
      sizesOf(cloudUnderPointSun(radians(20), {sized({"any", 1.0, any, RandomOrientation{}}, 250.0)}, absorbing(1e-6)));
  CHECK(fixed.mean() == doctest::Approx(250.0));
  CHECK(fixed.standardError() < 1e-9);
}
