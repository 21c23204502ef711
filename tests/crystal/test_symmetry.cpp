// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "crystal/population.h"
#include "crystal/symmetry.h"
#include "orientations.h"
#include "random_stream.h"
#include "statistics.h"

using namespace parhelion;

namespace {

// What tells one face from another in the sky is its kind; whether up and down differ, the crystal says.
int kindOf(const Face& face, bool endsAlike) {
  if (face.number <= 2) return endsAlike ? 1 : face.number;
  // Sides of prisms that are not regular differ by their areas.
  if (face.number <= 8) return 3 + 30 * static_cast<int>(std::lround(10.0 * face.area));
  return endsAlike ? 13 : (face.number < 20 ? 13 : 23);
}

/// Cells for numbers in [-1, 1], odd about 0: the mirror image of cell k is cell -k. The borders avoid the sines of
/// round angles, on which rounding would have to decide.
int cellOf(double x) { return static_cast<int>(std::lround(x / 0.1871)); }

using Cell = std::tuple<int, int, int, int, int>;

/// How far a set of independent draws is from its mirror image, for which the last number of a cell changes sign: each
/// of two cells that mirror each other then gets a hit with even chances. In standard deviations.
double sigmasFromMirror(const std::map<Cell, double>& counts) {
  double chiSquare = 0.0, pairs = 0.0;
  for (const auto& [cell, count] : counts) {
    auto mirrored = cell;
    std::get<4>(mirrored) *= -1;
    if (mirrored == cell) continue;
    const auto other = counts.find(mirrored);
    const double back = other == counts.end() ? 0.0 : other->second;
    if (back > 0.0 && std::get<4>(cell) < 0) continue;  // the pair has been seen or will be
    if (count + back < 20.0) continue;
    chiSquare += (count - back) * (count - back) / (count + back);
    pairs += 1.0;
  }
  if (pairs == 0.0) return 0.0;
  const double variance = 2.0 / (9.0 * pairs);  // Wilson & Hilferty
  return (std::cbrt(chiSquare / pairs) - (1.0 - variance)) / std::sqrt(variance);
}

/// The larger of two distances: of where single faces point, and of how pairs of faces wind about the vertical, which
/// shows a handedness that any azimuth hides from single faces.
double measuredAsymmetry(const PopulationSettings& settings) {
  constexpr int kDraws = 100'000;
  const Population population(settings);
  const auto* pyramid = std::get_if<PyramidSettings>(&settings.shape);
  const bool endsAlike = !pyramid || pyramid->upper == pyramid->lower;
  const auto& faces = population.mesh().faces();
  std::map<Cell, double> single, wound;
  for (int i = 0; i < kDraws; ++i) {
    RandomStream random(43, i, RandomPurpose::incidence);
    const double u1 = random.next(), u2 = random.next(), u3 = random.next();
    const Mat3 m = matrixOf(population.orientationQuantile().at(u1, u2, u3));
    const Face& a = faces[static_cast<std::size_t>(random.next() * static_cast<double>(faces.size()))];
    const Face& b = faces[static_cast<std::size_t>(random.next() * static_cast<double>(faces.size()))];
    const Vec3 na = m * a.normal, nb = m * b.normal;
    const int kinds = kindOf(a, endsAlike) * 10000 + kindOf(b, endsAlike);
    single[{kindOf(a, endsAlike), cellOf(na.x), cellOf(na.z), 0, cellOf(na.y)}] += 1.0;
    wound[{kinds, cellOf(na.z), cellOf(nb.z), 0, cellOf(glm::cross(na, nb).z)}] += 1.0;
  }
  return std::max(sigmasFromMirror(single), sigmasFromMirror(wound));
}

const AngleDistribution kFree = UniformRange{0.0, 2.0 * kPi};
// Triangular, and without any mirror that contains the c axis.
const PrismSettings kTriangle{FixedValue{0.5}, {1.0, 1.7, 1.0, 1.7, 1.0, 1.7}};
const PrismSettings kSkew{FixedValue{0.5}, {1.0, 1.3, 0.9, 1.0, 1.1, 0.8}};
const PyramidSettings kAlike{0.5, 0.6, 0.6}, kLopsided{0.5, 0.9, 0.2};

PopulationSettings crystals(const ShapeSettings& shape, const OrientationSettings& orientation) {
  return {"crystals", 1.0, shape, orientation};
}

OrientationSettings axis(const AngleDistribution& zenith, const AngleDistribution& azimuth,
                         const AngleDistribution& roll) {
  return AxisOrientation{zenith, azimuth, roll};
}

double deg(double d) { return radians(d); }

}  // namespace

TEST_CASE("populations called mirror symmetric about the sun's vertical look the same in the mirror") {
  const AngleDistribution tilted = FixedValue{deg(35)}, right = FixedValue{0.0}, level = FixedValue{deg(90)};
  std::vector<PopulationSettings> symmetric;
  for (const ShapeSettings& shape : std::vector<ShapeSettings>{PrismSettings{}, kLopsided}) {
    for (const OrientationSettings& orientation : std::vector<OrientationSettings>{
             RandomOrientation{},
             AxisOrientation{Normal{0.0, deg(20)}},
             AxisOrientation{Arcsine{0.0, deg(30)}},
             AxisOrientation{Normal{deg(90), deg(10)}},
             AxisOrientation{Laplace{deg(60), deg(10)}},
             axis(tilted, kFree, right),
             axis(tilted, kFree, FixedValue{deg(-30)}),
             axis(Normal{deg(90), deg(5)}, kFree, Normal{0.0, deg(4)}),
             axis(tilted, kFree, PolarNormal{deg(90), deg(4)}),
             axis(tilted, kFree, UniformRange{deg(13), deg(73)}),
             axis(tilted, UniformRange{deg(-40), deg(40)}, UniformRange{deg(-10), deg(10)}),
             axis(tilted, Laplace{deg(180), deg(20)}, Arcsine{deg(60), deg(12)}),
             axis(tilted, right, right),
             axis(UniformRange{deg(-15), deg(40)}, right, right),
             axis(Laplace{deg(5), deg(20)}, FixedValue{deg(180)}, right),
             axis(UniformRange{deg(120), deg(250)}, kFree, right),
             LowitzOrientation{PolarNormal{deg(90), deg(60)}, FixedValue{deg(25)}},
             LowitzOrientation{FixedValue{deg(270)}, FixedValue{deg(25)}},
             LowitzOrientation{},
             LowitzOrientation{Normal{deg(90), deg(12)}, FixedValue{deg(25)}},
             LowitzOrientation{Normal{deg(70), deg(5)}, UniformRange{deg(-30), deg(30)}},
             LowitzOrientation{FixedValue{deg(70)}, kFree}})
      symmetric.push_back(crystals(shape, orientation));
  }
  for (const ShapeSettings& endsAlike : std::vector<ShapeSettings>{PrismSettings{}, kAlike}) {
    symmetric.push_back(crystals(endsAlike, axis(level, kFree, FixedValue{deg(10)})));
    symmetric.push_back(
        crystals(endsAlike, axis(Normal{deg(90), deg(9)}, UniformRange{deg(70), deg(110)}, Normal{deg(7), deg(2)})));
    symmetric.push_back(crystals(endsAlike, LowitzOrientation{FixedValue{deg(70)}, FixedValue{deg(90)}}));
    symmetric.push_back(
        crystals(endsAlike, axis(PolarNormal{deg(90), deg(70)}, FixedValue{deg(90)}, FixedValue{deg(10)})));
    symmetric.push_back(crystals(endsAlike, axis(UniformRange{deg(-130), deg(-50)}, kFree, FixedValue{deg(10)})));
  }
  // Plates and columns of any sides that roll freely are turned over as often as not, or have their mirrors in the
  // planes of their ends.
  for (const PrismSettings& shape : {kTriangle, kSkew}) {
    symmetric.push_back(crystals(shape, RandomOrientation{}));
    symmetric.push_back(crystals(shape, AxisOrientation{Normal{deg(90), deg(10)}}));
  }
  symmetric.push_back(crystals(kTriangle, AxisOrientation{Normal{0.0, deg(20)}}));
  symmetric.push_back(crystals(kTriangle, axis(Normal{deg(90), deg(5)}, kFree, Normal{0.0, deg(4)})));
  for (std::size_t i = 0; i < symmetric.size(); ++i) {
    CAPTURE(i);
    CHECK(isMirrorSymmetric(symmetric[i]));
    CHECK(measuredAsymmetry(symmetric[i]) < kSigmas);
  }
}

TEST_CASE("populations that look different in the mirror are not called symmetric") {
  const AngleDistribution tilted = FixedValue{deg(35)}, right = FixedValue{0.0}, level = FixedValue{deg(90)};
  const std::vector<PopulationSettings> lopsided{
      crystals(kSkew, AxisOrientation{Normal{0.0, deg(20)}}),
      crystals(kSkew, axis(tilted, kFree, right)),
      crystals(kTriangle, axis(tilted, kFree, FixedValue{deg(10)})),
      crystals(PrismSettings{}, axis(tilted, FixedValue{deg(30)}, kFree)),
      crystals(PrismSettings{}, axis(tilted, right, FixedValue{deg(10)})),
      crystals(PrismSettings{}, axis(tilted, UniformRange{deg(-40), deg(40)}, FixedValue{deg(10)})),
      crystals(PrismSettings{}, axis(tilted, kFree, FixedValue{deg(10)})),
      crystals(PrismSettings{}, axis(tilted, kFree, UniformRange{deg(0), deg(50)})),
      crystals(PrismSettings{}, axis(tilted, UniformRange{deg(0), deg(180)}, kFree)),
      crystals(PrismSettings{}, axis(Normal{0.0, deg(20)}, kFree, Normal{deg(12), deg(3)})),
      crystals(PrismSettings{}, axis(tilted, kFree, FixedValue{deg(15)})),
      crystals(kLopsided, axis(level, kFree, FixedValue{deg(10)})),
      crystals(PrismSettings{}, axis(UniformRange{deg(-15), deg(40)}, FixedValue{deg(30)}, kFree)),
      crystals(PrismSettings{}, axis(PolarNormal{deg(5), deg(30)}, kFree, FixedValue{deg(10)})),
      crystals(PrismSettings{}, axis(level, UniformRange{deg(0), deg(60)}, FixedValue{deg(10)})),
      crystals(PrismSettings{}, axis(Normal{deg(70), deg(9)}, kFree, FixedValue{deg(10)})),
      crystals(PrismSettings{}, LowitzOrientation{FixedValue{deg(70)}, FixedValue{deg(25)}}),
      crystals(kLopsided, LowitzOrientation{FixedValue{deg(70)}, FixedValue{deg(90)}}),
  };
  for (std::size_t i = 0; i < lopsided.size(); ++i) {
    CAPTURE(i);
    CHECK_FALSE(isMirrorSymmetric(lopsided[i]));
    CHECK(measuredAsymmetry(lopsided[i]) > 4.0 * kSigmas);
  }
}

TEST_CASE("only random orientations are fully random") {
  CHECK(isFullyRandom(crystals(PrismSettings{}, RandomOrientation{})));
  CHECK_FALSE(isFullyRandom(crystals(PrismSettings{}, AxisOrientation{UniformRange{0.0, kPi}})));
  CHECK_FALSE(isFullyRandom(crystals(PrismSettings{}, LowitzOrientation{})));
}
