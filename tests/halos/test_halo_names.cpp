// SPDX-License-Identifier: Apache-2.0
// The light that the name of a halo stands for is where that halo is.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "crystal/raypath/halo_paths.h"
#include "halos/closed_forms.h"
#include "halos/experiment.h"
#include "optics/halo_forms.h"

using namespace parhelion;

namespace {

/// A ray of light that the filter has kept.
struct Kept {
  double azimuth, elevation, deviation;  // degrees; azimuth to either side
  double energy;
  Vec3 toSky;
};

struct KeptFilm : Film {
  std::vector<Kept> all;

  int add(const TracedRays& traced) override {
    const auto& [queue, exits, members, population, mesh, steps] = traced;
    for (int i = 0; i < exits.count; ++i) {
      const int place = queue.placeOf(static_cast<int>(exits.ray[i]));
      const Vec3 light(queue.lightWorld[0][place], queue.lightWorld[1][place], queue.lightWorld[2][place]);
      const SkyPoint sky = skyPoint(-exits.lightDir(i));
      all.push_back({std::abs(degrees(sky.azimuth)), degrees(sky.elevation),
                     degrees(angleBetween(light, exits.lightDir(i))), exits.energy[i], -exits.lightDir(i)});
    }
    return exits.count;
  }
  std::unique_ptr<Film> forThread() override { return std::make_unique<KeptFilm>(); }
  void merge(Film& other) override {
    const auto& more = dynamic_cast<KeptFilm&>(other).all;
    all.insert(all.end(), more.begin(), more.end());
  }
};

OrientationSettings orientationOf(Stance stance) {
  switch (stance) {
    case Stance::random:
      return RandomOrientation{};
    case Stance::plate:
      return plateOrientation();
    case Stance::column:
      return columnOrientation();
    case Stance::parry:
      return parryOrientation();
    case Stance::lowitz:
      return LowitzOrientation{};
  }
  return RandomOrientation{};
}

/// The light that a name stands for, of perfectly oriented crystals of one shape.
constexpr double kSun = 20.0;

std::vector<Kept> lightOf(std::string_view name, double sunElevation = kSun, double aspect = 0.5,
                          std::uint64_t rays = 300'000, std::optional<Stance> stance = {}) {
  const auto named = halosNamed(name);
  REQUIRE_FALSE(named.empty());
  const HaloPath* halo = named.front();
  PopulationSettings population = prisms(aspect, orientationOf(stance.value_or(halo->stances.front())));
  if (halo->pattern.find('1') != std::string_view::npos && halo->pattern.find("13-") != std::string_view::npos)
    population.shape = PyramidSettings{aspect, 0.7, 0.7};
  for (const char* pyramidal : {"16", "15", "23"})
    if (halo->pattern.find(pyramidal) != std::string_view::npos) population.shape = PyramidSettings{aspect, 0.7, 0.7};
  KeptFilm film;
  TraceSettings settings{.rays = rays};
  settings.paths.filter = parsePathPattern(name);
  traceRays(cloudUnderPointSun(radians(sunElevation), {population}), settings, 0, film);
  REQUIRE(film.all.size() > 100);
  return film.all;
}

template <class Of>
double least(const std::vector<Kept>& light, const Of& of) {
  return std::ranges::min(light, {}, of).*of;
}
template <class Of>
double most(const std::vector<Kept>& light, const Of& of) {
  return std::ranges::max(light, {}, of).*of;
}

/// The centre of the bin of 0.1 degrees with most light.
template <class Of>
double peak(const std::vector<Kept>& light, const Of& of) {
  std::vector<double> bins(3600, 0.0);
  for (const Kept& one : light) bins[static_cast<std::size_t>((one.*of + 180.0) * 10.0)] += one.energy;
  return static_cast<double>(std::ranges::max_element(bins) - bins.begin()) / 10.0 - 180.0 + 0.05;
}

/// Where the light of a ring begins: the first bin of 0.1 degrees that has a quarter of the light, for its size, of
/// the densest within two degrees. The density of random crystals has a step there.
double edge(const std::vector<Kept>& light) {
  std::vector<double> bins(1800, 0.0);
  for (const Kept& one : light)
    bins[static_cast<std::size_t>(one.deviation * 10.0)] += one.energy / std::sin(radians(one.deviation));
  const auto first = std::ranges::find_if(bins, [](double b) { return b > 0.0; });
  const double most = *std::max_element(first, first + 20);
  return static_cast<double>(std::find_if(first, bins.end(), [&](double b) { return b >= 0.25 * most; }) -
                             bins.begin()) /
             10.0 +
         0.05;
}

/// Degrees of light from the lines of a halo of that name.
std::vector<double> distances(const std::vector<Kept>& light, std::string_view name, double sunElevation = kSun) {
  const HaloForms forms = haloForms(radians(sunElevation), kIndex);
  const auto curve = std::ranges::find(forms.curves, name, &HaloCurve::name);
  REQUIRE(curve != forms.curves.end());
  std::vector<double> all;
  for (const Kept& one : light) {
    double nearest2 = 4.0;
    for (const SkyLine& line : curve->lines)
      for (std::size_t i = 1; i < line.size(); ++i) {
        const Vec3 piece = line[i] - line[i - 1];
        const double along = std::clamp(glm::dot(one.toSky - line[i - 1], piece) / glm::dot(piece, piece), 0.0, 1.0);
        const Vec3 off = one.toSky - (line[i - 1] + along * piece);
        nearest2 = std::min(nearest2, glm::dot(off, off));
      }
    all.push_back(degrees(std::sqrt(nearest2)));
  }
  return all;
}

/// All light is at this value of a coordinate.
template <class Of>
void checkAllAt(const std::vector<Kept>& light, const Of& of, double where) {
  CHECK(least(light, of) == doctest::Approx(where).epsilon(1e-7).scale(100));
  CHECK(most(light, of) == doctest::Approx(where).epsilon(1e-7).scale(100));
}

}  // namespace

TEST_CASE("each name of a halo keeps light where that halo is") {
  struct Ring {
    const char* name;
    double least;  // n = 1.31
    double aspect = 0.5;
  };
  for (const auto& [name, where, aspect] : std::vector<Ring>{{"22° halo", 21.839},
                                                             {"46° halo", 45.733},
                                                             {"9° halo", 8.953},
                                                             {"18° halo", 18.271},
                                                             {"20° halo", 19.905},
                                                             {"23° halo", 22.862, 0.05},
                                                             {"24° halo", 23.819},
                                                             {"35° halo", 34.929},
                                                             {"circumscribed halo", 21.839},
                                                             {"upper tangent arc", 21.839},
                                                             {"lower tangent arc", 21.839},
                                                             {"Lowitz arc", 21.839}}) {
    CAPTURE(std::string(name));
    const auto light = lightOf(name, kSun, aspect, 2'000'000);
    CHECK(least(light, &Kept::deviation) > where - 1e-3);
    CHECK(least(light, &Kept::deviation) < where + 0.1);
    if (halosNamed(name).front()->stances == std::vector{Stance::random}) CHECK(std::abs(edge(light) - where) < 0.1);
  }

  const auto parhelion = lightOf("parhelion");
  checkAllAt(parhelion, &Kept::elevation, kSun);
  CHECK(std::abs(peak(parhelion, &Kept::azimuth) - 24.576) < 0.1);
  const auto subparhelion = lightOf("subparhelion");
  checkAllAt(subparhelion, &Kept::elevation, -kSun);
  CHECK(std::abs(peak(subparhelion, &Kept::azimuth) - 24.576) < 0.1);
  checkAllAt(lightOf("circumzenithal arc"), &Kept::elevation, degrees(theory::circumzenithal(kIndex, radians(kSun))));
  checkAllAt(lightOf("circumhorizontal arc", 60.0), &Kept::elevation,
             degrees(theory::circumhorizontal(kIndex, radians(60.0))));
  for (const Stance stance : {Stance::plate, Stance::column, Stance::parry})
    checkAllAt(lightOf("parhelic circle", kSun, 1.0, 300'000, stance), &Kept::elevation, kSun);
  const auto at120 = lightOf("120° parhelion");
  checkAllAt(at120, &Kept::elevation, kSun);
  checkAllAt(at120, &Kept::azimuth, 120.0);
  // One more reflection by the plate's other end turns light upside down.
  const auto subparhelic = lightOf("subparhelic circle", kSun, 1.0);
  checkAllAt(subparhelic, &Kept::elevation, -kSun);
  CHECK(least(subparhelic, &Kept::azimuth) < 20.0);
  CHECK(most(subparhelic, &Kept::azimuth) > 170.0);
  const auto below120 = lightOf("120° subparhelion", kSun, 1.0);
  checkAllAt(below120, &Kept::elevation, -kSun);
  checkAllAt(below120, &Kept::azimuth, 120.0);
  checkAllAt(lightOf("subcircumzenithal arc"), &Kept::elevation,
             -degrees(theory::circumzenithal(kIndex, radians(kSun))));
  for (const char* name : {"subsun", "sun pillar"}) {  // of plates that do not tilt a pillar is the subsun
    const auto light = lightOf(name);
    checkAllAt(light, &Kept::elevation, -kSun);
    CHECK(most(light, &Kept::azimuth) < 1e-4);
  }
}

TEST_CASE("columns' arcs are where closed forms put them") {
  // Light of 90 degree wedges that touches the 46 degree ring: the supralateral arc from above, the infralateral arcs
  // from the sides and below.
  const auto supralateral = lightOf("supralateral arc", kSun, 2.0),
             infralateral = lightOf("infralateral arc", kSun, 2.0);
  for (const auto& light : {supralateral, infralateral}) {
    CHECK(least(light, &Kept::deviation) > 45.733 - 1e-3);
    CHECK(least(light, &Kept::deviation) < 45.733 + 0.1);
  }
  CHECK(most(supralateral, &Kept::elevation) > kSun + 45.733 - 0.5);
  CHECK(peak(supralateral, &Kept::elevation) > kSun);
  CHECK(peak(infralateral, &Kept::elevation) < kSun);
  CHECK(most(infralateral, &Kept::elevation) < kSun + 20.0);
  // Of light that would make tangent arcs, an end's reflection turns around what goes along the axis.
  const auto wegener = lightOf("Wegener arc", kSun, 2.0);
  CHECK(least(wegener, &Kept::deviation) > 21.839 - 1e-3);
  CHECK(least(wegener, &Kept::deviation) < 21.839 + 0.3);
  const auto hastings = lightOf("Hastings arc", kSun, 2.0);
  CHECK(least(hastings, &Kept::deviation) > 21.839 - 1e-3);
  // In the sun's vertical the upper suncave Parry arc stands where its closed form says.
  auto parry = lightOf("Parry arc", kSun, 2.0);
  std::erase_if(parry, [](const Kept& one) { return one.azimuth > 1.0 || one.elevation < 45.0; });
  REQUIRE(parry.size() > 20);
  CHECK(std::abs(peak(parry, &Kept::elevation) - 48.699) < 0.1);
}

TEST_CASE("in the sun's vertical tangent arcs are brightest where they touch the ring of 22 degrees") {
  for (const double side : {-1.0, 1.0}) {
    auto light = lightOf("upper tangent arc", kSun, 2.0, 4'000'000);
    std::erase_if(light, [&](const Kept& one) { return one.azimuth > 0.15 || (one.elevation - kSun) * side < 0.0; });
    REQUIRE(light.size() > 500);
    CHECK(std::abs(peak(light, &Kept::elevation) - (kSun + side * 21.839)) < 0.1);
  }
}

TEST_CASE("light of the rare arcs' names lies on their lines") {
  // A line's chords of a quarter of a degree keep that near to it.
  constexpr double kChords = 2e-3;  // degrees
  struct Arc {
    const char* name;
    double sun, aspect;
    Stance stance;
  };
  for (const auto& [name, sun, aspect, stance] : std::vector<Arc>{{"heliac arc", 20, 2, Stance::parry},
                                                                  {"heliac arc", 60, 2, Stance::parry},
                                                                  {"subhelic arc", 20, 2, Stance::column},
                                                                  {"subhelic arc", 50, 2, Stance::parry},
                                                                  {"Tricker arc", 20, 1.5, Stance::column},
                                                                  {"Tricker arc", 5, 1.5, Stance::parry}}) {
    CAPTURE(std::string(name));
    CAPTURE(sun);
    const auto light = lightOf(name, sun, aspect, 100'000, stance);
    CHECK(std::ranges::max(distances(light, name, sun)) < kChords);
  }
  // The diffuse arcs are broad. Counts of some hundreds scatter by a twentieth: the factor of two is ten sigma.
  const auto off = distances(lightOf("diffuse arcs", kSun, 2.0), "diffuse arcs");
  const auto within = [&](double from, double to) {
    return static_cast<double>(std::ranges::count_if(off, [&](double d) { return d >= from && d < to; })) / (to - from);
  };
  CHECK(within(0.0, 0.5) > 2.0 * within(3.0, 6.0));
}

TEST_CASE("the antisolar arc is opposite to a reflection by planes that slope by 30 degrees") {
  // Light is turned by half a turn about a line across c that is at 60 degrees to the horizon: opposite to where that
  // line's plane would mirror it. So the line is halfway between the sun and the arc.
  for (const double sun : {10.0, kSun, 40.0}) {
    const Vec3 toSun(std::cos(radians(sun)), 0.0, std::sin(radians(sun)));
    double nearest = 180.0;
    for (const Kept& one : lightOf("antisolar arc", sun, 1.0, 300'000)) {
      const Vec3 halfway = toSun + one.toSky;
      nearest = std::min(nearest, degrees(glm::length(halfway)));
      if (glm::length(halfway) > 1e-3)
        CHECK(std::abs(halfway.z) / glm::length(halfway) == doctest::Approx(std::sin(radians(60.0))).epsilon(1e-6));
    }
    // The line can lie across the light up to this sun, and then the arc passes through the antisolar point.
    if (sun < 30.0) CHECK(nearest < 1.0);
  }
}

TEST_CASE("the Kern arc completes the circle of the circumzenithal arc") {
  const auto kern = lightOf("Kern arc", kSun, 0.6), arc = lightOf("circumzenithal arc", kSun, 0.6);
  checkAllAt(kern, &Kept::elevation, degrees(theory::circumzenithal(kIndex, radians(kSun))));
  CHECK(most(arc, &Kept::azimuth) < 90.0);
  CHECK(most(kern, &Kept::azimuth) > 170.0);
}

TEST_CASE("Liljequist parhelia are brightest where two of their reflections cease to be total") {
  for (const double sun : {0.01, 10.0}) {
    const double n = theory::bravaisIndex(kIndex, radians(sun));
    const double brightest = 2.0 * std::acos(n * std::sin(radians(60) - std::asin(1.0 / n)));
    // Total reflection ends there at once: the light falls to a quarter within two degrees. By other paths the light is
    // spread over 20 degrees.
    const auto light = lightOf("Liljequist parhelion", sun, 1.0, 3'000'000);
    checkAllAt(light, &Kept::elevation, sun);
    CHECK(std::abs(peak(light, &Kept::azimuth) - degrees(brightest)) < 0.5);
  }
}

TEST_CASE("every name of a halo keeps light") {
  for (const HaloPath& halo : haloPaths()) {
    CAPTURE(halo.name);
    const double sun = halo.name == "circumhorizontal arc" ? 60.0 : kSun;
    // Only of thin plates does light reach the lower end and then a side.
    const double aspect = halo.name == "subcircumzenithal arc" ? 0.3 : 1.0;
    CHECK_FALSE(lightOf(halo.name, sun, aspect, 50'000).empty());
  }
}
