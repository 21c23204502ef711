// SPDX-License-Identifier: Apache-2.0
// Light of raypaths that are wanted, against closed forms and against all light.
#include <cmath>
#include <numeric>
#include <random>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "beam/light_class.h"
#include "beam/wanted_tracer.h"
#include "crystal/population.h"
#include "crystal/raypath/path_pattern.h"
#include "crystal/raypath/path_symmetry.h"

using namespace parhelion;

namespace {

constexpr double kIndex = 1.31;
// Pieces of less light go on as one ray each: of all light, and what that makes of many of them.
constexpr double kCut = 1e-7, kManyCuts = 300.0;
const std::vector<int> kNumbers{1, 2, 3, 4, 5, 6, 7, 8};

/// The paths of a pattern as it stands, or with its images in crystals of an orientation.
WantedPaths pathsOf(const std::string& text, const std::vector<std::vector<int>>& images = {{0, 1, 2, 3, 4, 5, 6, 7}},
                    const std::vector<int>& numbers = kNumbers) {
  const PathPattern pattern = parsePathPattern(text);
  const SymmetricPattern symmetric{&pattern, images};
  const PathAutomaton automaton(numbers, std::span(&symmetric, 1));
  std::vector<bool> wanted;
  for (int state = 0; state < automaton.states(); ++state) wanted.push_back(automaton.accepted(state).any());
  return {automaton, numbers, wanted};
}

WantedPaths pathsIn(const std::string& text, const OrientationSettings& orientation) {
  PopulationSettings settings;
  settings.shape = PrismSettings{};
  settings.orientation = orientation;
  const Population population(settings);
  std::vector<int> numbers;
  for (const Face& face : population.mesh().faces()) numbers.push_back(face.number);
  return pathsOf(text, pathSymmetries(population.mesh(), orientation, parsePathPattern(text).symmetry), numbers);
}

Vec3 someDirection(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return glm::normalize(Vec3(normal(random), normal(random), normal(random)));
}

PrismLight lightOf(const WantedPaths* wanted, double length, const Vec3& lightDir, double cutShare) {
  PrismLight light;
  WantedTracer tracer(PrismSection(), length, kIndex, cutShare, false, wanted);
  tracer.trace(lightDir, light);
  return light;
}

/// By class, over all that comes.
std::vector<double> classesOf(const PrismLight& light) {
  std::vector<double> all(kLightClasses, 0.0);
  forEachClass(light,
               [&](int number, double met) { all[static_cast<std::size_t>(number)] = met / light.totalShadow(); });
  return all;
}

/// By how much all classes together differ whose light gets out: strips leave out what meets ends that let none
/// through.
double apartWhereOut(const std::vector<double>& a, const std::vector<double>& b, const Vec3& lightDir) {
  double sum = 0.0;
  for (int number = 0; number < kLightClasses; ++number) {
    const auto exit =
        LightClass(number).exit(Triple<double>{lightDir.x, lightDir.y, lightDir.z}, RelativeIndexOf<double>(kIndex));
    const auto n = static_cast<std::size_t>(number);
    if (exit.excess > 0.0) sum += std::abs(a[n] - b[n]);
  }
  return sum;
}

double sumOf(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

TEST_CASE("light that went by pieces from face to face is that of strips, class by class") {
  std::mt19937_64 random(5);
  // None of it is short, so that neither strips nor what is left by others can stand for it.
  const WantedPaths all = pathsOf("*"), even = pathsOf("?-*-?|?");
  REQUIRE_FALSE(all.areShort());
  for (const double length : {0.3, 2.0, 7.0})
    for (int k = 0; k < 12; ++k) {
      const Vec3 lightDir = someDirection(random);
      PrismLight pieces, strips;
      PrismTracer tracer(PrismSection(), length, kIndex, kCut);
      tracer.trace(lightDir, strips);
      pieces = strips;
      PieceTracer(PrismSection(), length, kIndex, kCut, false, even).trace(lightDir, pieces);
      const std::vector<double> a = classesOf(pieces), b = classesOf(strips);
      CHECK(apartWhereOut(a, b, lightDir) < kManyCuts * kCut);
    }
}

TEST_CASE("light from side to side straight through is as much as has not met an end") {
  const WantedPaths wanted = pathsOf("3-6");
  CHECK(wanted.areShort());
  const double length = 3.0, fall = 0.4;  // of the light's direction, downwards
  const Vec3 lightDir = glm::normalize(Vec3(-1.0, 0.0, -fall));
  const PrismLight light = lightOf(&wanted, length, lightDir, 1e-5);
  const double sine = fall / std::sqrt(1.0 + fall * fall) / kIndex, inside = sine / std::sqrt(1.0 - sine * sine);
  const double share = 1.0 - std::sqrt(3.0) * inside / length;
  CHECK(light.arrived[0][0][3] == doctest::Approx(share).epsilon(1e-12));
  std::vector<double> all = classesOf(light);
  CHECK(sumOf(all) == doctest::Approx(light.shadow[0] * (1.0 - light.reflectance[0]) * share / light.totalShadow()));
}

TEST_CASE("light by the end below, then by a side, is that of the mirrored image") {
  std::mt19937_64 random(7);
  const WantedPaths down = pathsOf("1-3-2-6|3-1-5"), up = down.upsideDown();
  for (int k = 0; k < 20; ++k) {
    Vec3 lightDir = someDirection(random);
    const PrismLight a = lightOf(&down, 1.5, lightDir, 1e-5);
    lightDir.z = -lightDir.z;
    const PrismLight b = lightOf(&up, 1.5, lightDir, 1e-5);
    CHECK(sumOf(classesOf(a)) == doctest::Approx(sumOf(classesOf(b))).epsilon(1e-9));
  }
}

TEST_CASE("light that is wanted and all other light are all light, however long their paths") {
  std::mt19937_64 random(11);
  double most = 0.0;
  for (const char* text : {"3-5", "not 3-5", "3", "1-3|3-1-5|1-2-1", "*-basal-*", "3-*-5", "prism-*, hits = 3..4"}) {
    CAPTURE(text);
    const WantedPaths wanted = pathsOf(text), unwanted = wanted.others();
    for (int k = 0; k < 10; ++k) {
      const Vec3 lightDir = someDirection(random);
      const std::vector<double> a = classesOf(lightOf(&wanted, 2.0, lightDir, kCut)),
                                others = classesOf(lightOf(&unwanted, 2.0, lightDir, kCut)),
                                all = classesOf(lightOf(nullptr, 2.0, lightDir, kCut));
      std::vector<double> both = a;
      for (std::size_t n = 0; n < both.size(); ++n) both[n] += others[n];
      CHECK(apartWhereOut(both, all, lightDir) < kManyCuts * kCut);
      most = std::max(most, sumOf(a));
    }
  }
  CHECK(most > 0.5);
}

TEST_CASE("what is wanted of crystals that turn about c does not depend on the side that light comes from") {
  const OrientationSettings plates = AxisOrientation{}, random = RandomOrientation{};
  CHECK(pathsIn("3-5", plates).areAlikeAboutC());
  CHECK(pathsIn("3-5", plates).areAlikeUpsideDown());
  CHECK(pathsIn("1-3", random).areAlikeUpsideDown());
  CHECK(pathsIn("*-1-*", random).areAlikeAboutC());
  CHECK_FALSE(pathsIn("3-5, symmetry = none", random).areAlikeAboutC());
  CHECK(pathsIn("prism-basal, symmetry = none", random).areAlikeAboutC());
  CHECK(pathsIn("*, hits = 2..3, symmetry = none", random).areAlikeUpsideDown());
  CHECK_FALSE(
      pathsIn("1-3", AxisOrientation{FixedValue{0.0}, UniformRange{0.0, 2.0 * kPi}, UniformRange{0.0, 2.0 * kPi}})
          .areAlikeUpsideDown());
}

TEST_CASE("paths are short if all of them are") {
  CHECK(pathsOf("3-1-5").areShort());
  CHECK(pathsOf("*-1-*, hits = ..9").areShort());
  CHECK_FALSE(pathsOf("*-1-*, hits = ..10").areShort());
  CHECK_FALSE(pathsOf("not 3").areShort());
  CHECK(pathsOf("not *").isNothing());
  CHECK(pathsOf("*").others().isNothing());
}
