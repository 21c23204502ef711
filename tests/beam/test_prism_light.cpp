// SPDX-License-Identifier: Apache-2.0
// The light in a prism that stands still, against the ledger, against the group of reflections, and against single rays
// that are followed here by other means.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "beam/end_crossings.h"
#include "beam/prism_tracer.h"
#include "statistics.h"

using namespace parhelion;

namespace {

Vec3 vectorOf(const Triple<double>& v) { return {v.x, v.y, v.z}; }
Triple<double> tripleOf(const Vec3& v) { return {v.x, v.y, v.z}; }

Vec3 someDirection(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return glm::normalize(Vec3(normal(random), normal(random), normal(random)));
}

/// A hexagon whose sides all differ.
PrismSection irregularSection() { return PrismSection({0.8, 0.9, 0.75, 0.85, 0.95, 0.7}); }

/// What becomes of all light of a direction: what leaves, and what is cut off, over what comes.
double ledger(const PrismLight& light, const Vec3& lightDir, double index) {
  double sum = 0.0;
  for (int entry = 0; entry < kPrismFaces; ++entry) {
    if (light.shadow[entry] == 0.0) continue;
    const double outside = light.shadow[entry] * light.reflectance[entry], goesIn = light.shadow[entry] - outside;
    sum += outside + goesIn * light.cutOff[entry];
    for (int element = 0; element < kPrismElements; ++element)
      for (int exit = 0; exit < kPrismFaces; ++exit)
        sum += goesIn * light.arrived[entry][element][exit] *
               exitOf({entry, element, exit}, tripleOf(lightDir), RelativeIndex(index)).transmittance;
  }
  return sum / light.totalShadow();
}

/// Follows one ray after the other from uniform points of a face, splitting nowhere: at each face it counts what meets
/// it and goes on with what is reflected, down to nothing.
class SingleRays {
 public:
  SingleRays(const PrismSection& section, double length, double index)
      : section_(section), length_(length), index_(index) {}

  /// Arrivals of one ray that enters by `entry`: sums over its way by element and face.
  PrismLight::Arrivals arrivals(int entry, const Vec3& lightDir, std::mt19937_64& random) {
    PrismLight::Arrivals met{};
    Vec3 at = pointOn(entry, random);
    const Vec3 normal = vectorOf(normalOfPrismFace<double>(entry));
    const double in = -glm::dot(normal, lightDir);
    Vec3 dir = (lightDir + (in - std::sqrt(index_ * index_ - 1.0 + in * in)) * normal) / index_;
    const Vec3 first = dir;
    int left = entry;
    for (double energy = 1.0; energy > 1e-9;) {
      const int face = nextFace(at, dir, left);
      met[elementOf(first, dir)][face] += energy;
      const Vec3 n = vectorOf(normalOfPrismFace<double>(face));
      energy *= fresnel(glm::dot(n, dir), RelativeIndex(1.0 / index_)).reflectance;
      dir -= 2.0 * glm::dot(n, dir) * n;
      left = face;
    }
    return met;
  }

 private:
  double offset(int face) const { return face < kUpperEnd ? section_.distance[face] : 0.5 * length_; }

  Vec3 pointOn(int face, std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform;
    if (face < kUpperEnd) {
      const Vec2 at = section_.corner[face] + uniform(random) * section_.side[face] * section_.tangent[face];
      return {at, (uniform(random) - 0.5) * length_};
    }
    for (;;) {
      const Vec2 at(4.0 * uniform(random) - 2.0, 4.0 * uniform(random) - 2.0);
      bool inside = true;
      for (int k = 0; k < 6; ++k) inside = inside && glm::dot(section_.normal[k], at) < section_.distance[k];
      if (inside) return {at, face == kUpperEnd ? 0.5 * length_ : -0.5 * length_};
    }
  }

  int nextFace(Vec3& at, const Vec3& dir, int left) const {
    double nearest = 1e300;
    int found = -1;
    for (int face = 0; face < kPrismFaces; ++face) {
      const Vec3 n = vectorOf(normalOfPrismFace<double>(face));
      if (face == left || !(glm::dot(n, dir) > 0.0)) continue;
      const double way = (offset(face) - glm::dot(n, at)) / glm::dot(n, dir);
      if (way < nearest) {
        nearest = way;
        found = face;
      }
    }
    at += nearest * dir;
    return found;
  }

  static int elementOf(const Vec3& first, const Vec3& now) {
    const int odd = first.z * now.z < 0.0;
    for (int plane = 0; plane < kPlaneElements; ++plane)
      if (glm::length(inPlane(plane, Vec2(first)) - Vec2(now)) < 1e-9) return plane + kPlaneElements * odd;
    FAIL("no element of the group");
    return 0;
  }

  const PrismSection& section_;
  double length_, index_;
};

}  // namespace

TEST_CASE("a prism's section has the sides and the area that its distances give") {
  const PrismSection regular;
  CHECK(regular.area == doctest::Approx(1.5 * std::sqrt(3.0)).epsilon(1e-15));
  for (const double side : regular.side) CHECK(side == doctest::Approx(1.0).epsilon(1e-15));
  CHECK(regular.surface(2.0) == doctest::Approx(12.0 + 3.0 * std::sqrt(3.0)).epsilon(1e-15));
  // Two of a regular hexagon's sides moved in until the two between them are gone leave a rhombus with a corner cut.
  CHECK_THROWS_AS(PrismSection({1.0, 1.0, 1.0, 3.0, 1.0, 1.0}), std::invalid_argument);
  const PrismSection section = irregularSection();
  double area = 0.0;
  for (std::size_t k = 0; k < 6; ++k) {
    const Vec2 a = section.corner[k], b = section.corner[(k + 1) % 6];
    area += 0.5 * (a.x * b.y - a.y * b.x);
    CHECK(glm::dot(section.normal[k], a) == doctest::Approx(section.distance[k]).epsilon(1e-14));
    CHECK(glm::dot(section.normal[k], b) == doctest::Approx(section.distance[k]).epsilon(1e-14));
  }
  CHECK(section.area == doctest::Approx(area).epsilon(1e-14));
}

TEST_CASE("chains of reflections in side faces come to six elements") {
  std::mt19937_64 random(1);
  const PrismSection section;
  for (int chain = 0; chain < 100; ++chain) {
    const Vec2 first(someDirection(random));
    Vec2 dir = first;
    int element = 0;
    for (int step = 0; step < 30; ++step) {
      const auto side = random() % 6;
      dir -= 2.0 * glm::dot(section.normal[side], dir) * section.normal[side];
      element = afterReflection(element, static_cast<int>(side));
      CHECK(glm::length(inPlane(element, first) - dir) < 1e-13);
    }
  }
}

TEST_CASE("light between two ends is told by how often it met them") {
  // Against sums over starts and places, one by one.
  for (const double reflectance : {0.02, 0.7, 1.0})
    for (const bool window : {true, false}) {
      if (!window && reflectance == 1.0) continue;
      CAPTURE(reflectance);
      CAPTURE(window);
      EndCrossings ends;
      ends.reset(reflectance, window);
      for (const auto& [y0, y1] : {std::pair(1.2, 1.4), {1.3, 7.9}, {5.0, 5.0}, {23.4, 2.0}}) {
        constexpr int kSteps = 2000;
        std::array<double, 4> sum{};
        for (int i = 0; i < kSteps; ++i) {
          const double top = y0 + (y1 - y0) * (i + 0.5) / kSteps, bottom = window ? top - 1.0 : 0.0;
          for (int j = 0; j < kSteps / 4; ++j) {
            const double y = bottom + (top - bottom) * (j + 0.5) / (kSteps / 4);
            const double per = (top - bottom) / (kSteps / 4) / kSteps;
            double left = 1.0;
            int met = 0;
            for (; met + 1 <= y; ++met) {
              if (reflectance < 1.0) sum[2 + met % 2] += per * left;
              left *= reflectance;
            }
            sum[met % 2] += per * left;
          }
        }
        const EndCrossings::Four mean = ends.mean(y0, y1);
        for (int k = 0; k < 4; ++k) CHECK(mean[k] == doctest::Approx(sum[k]).epsilon(2e-3).scale(1.0));
      }
    }
}

TEST_CASE("all light that comes to a prism leaves it or is cut off") {
  std::mt19937_64 random(2);
  PrismLight light;
  for (const PrismSection& section : {PrismSection(), irregularSection()})
    for (const double index : {1.2, 1.31, 1.45})
      for (const double length : {2e-3, 0.1, 2.0, 40.0}) {
        CAPTURE(index);
        CAPTURE(length);
        PrismTracer tracer(section, length, index, 1e-5);
        double cut = 0.0, all = 0.0, worst = 0.0;
        for (int i = 0; i < 300; ++i) {
          const Vec3 lightDir = someDirection(random);
          tracer.trace(lightDir, light);
          worst = std::max(worst, std::abs(ledger(light, lightDir, index) - 1.0));
          for (int entry = 0; entry < kPrismFaces; ++entry)
            cut += light.shadow[entry] * (1.0 - light.reflectance[entry]) * light.cutOff[entry];
          all += light.totalShadow();
        }
        CHECK(worst < 1e-12);
        CHECK(cut < 2e-6 * all);
      }
}

TEST_CASE("light that runs along faces or straight through is not lost") {
  PrismLight light;
  PrismTracer tracer(PrismSection(), 2.0, 1.31, 1e-6, true);
  const double half = 0.5, wide = 0.5 * std::sqrt(3.0);
  for (const Vec3& lightDir : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(wide, half, 0),
                               Vec3(-half, wide, 0), Vec3(0, wide, half), Vec3(wide, 0, -half), Vec3(1e-13, 0, -1)}) {
    CAPTURE(lightDir.x);
    CAPTURE(lightDir.y);
    CAPTURE(lightDir.z);
    const Vec3 unit = glm::normalize(lightDir);
    tracer.trace(unit, light);
    CHECK(std::abs(ledger(light, unit, 1.31) - 1.0) < 1e-12);
    CHECK(std::isfinite(light.path));
  }
}

TEST_CASE("what meets a prism's faces is what single rays bring there") {
  std::mt19937_64 random(3);
  PrismLight light;
  constexpr int kRays = 20'000;
  double worst = 0.0;
  int compared = 0;
  for (int scene = 0; scene < 8; ++scene) {
    const PrismSection section = scene % 2 ? irregularSection() : PrismSection();
    const double length = std::exp(std::uniform_real_distribution<double>(std::log(0.1), std::log(10.0))(random));
    const double index = std::uniform_real_distribution<double>(1.2, 1.4)(random);
    const Vec3 lightDir = someDirection(random);
    PrismTracer(section, length, index, 1e-9).trace(lightDir, light);
    SingleRays rays(section, length, index);
    for (int entry = 0; entry < kPrismFaces; ++entry) {
      if (!(light.shadow[entry] > 0.0)) continue;
      std::array<std::array<double, kPrismFaces>, kPrismElements> sum{}, squares{};
      for (int ray = 0; ray < kRays; ++ray) {
        const PrismLight::Arrivals one = rays.arrivals(entry, lightDir, random);
        for (int e = 0; e < kPrismElements; ++e)
          for (int x = 0; x < kPrismFaces; ++x) {
            sum[e][x] += one[e][x] / kRays;
            squares[e][x] += one[e][x] * one[e][x] / kRays;
          }
      }
      for (int e = 0; e < kPrismElements; ++e)
        for (int x = 0; x < kPrismFaces; ++x) {
          // Ends under total reflection are not told: nothing leaves there.
          if (exitOf({entry, e, x}, tripleOf(lightDir), RelativeIndex(index)).transmittance == 0.0) continue;
          const double error = std::sqrt((squares[e][x] - sum[e][x] * sum[e][x]) / kRays);
          if (error == 0.0 || sum[e][x] * kRays < 20.0) continue;
          worst = std::max(worst, std::abs(light.arrived[entry][e][x] - sum[e][x]) / error);
          ++compared;
        }
    }
  }
  CHECK(compared > 300);
  CHECK(worst < kSigmas);
}

TEST_CASE("light by order and the way inside are those of single rays in a slab") {
  // Straight down on a plate: order k leaves with (1 - R)^2 R^(k - 1), and each leg is one length.
  PrismLight light;
  PrismTracer tracer(PrismSection(), 0.5, 1.31, 1e-6, true);
  tracer.trace(Vec3(0.0, 0.0, -1.0), light);
  const double r = std::pow(0.31 / 2.31, 2.0), goesIn = light.totalShadow() * (1.0 - r);
  for (int k = 1; k < 6; ++k)
    CHECK(light.byOrder[k - 1] == doctest::Approx(goesIn * (1.0 - r) * std::pow(r, k - 1)).epsilon(1e-12));
  CHECK(light.path == doctest::Approx(goesIn * 0.5 / (1.0 - r)).epsilon(1e-12));
}

TEST_CASE("light by order and cut-off light add up to what goes in") {
  std::mt19937_64 random(4);
  PrismLight light;
  PrismTracer tracer(PrismSection(), 2.0, 1.31, 1e-3, true);
  for (int i = 0; i < 200; ++i) {
    tracer.trace(someDirection(random), light);
    double sum = 0.0, goesIn = 0.0;
    for (const double order : light.byOrder) sum += order;
    for (int entry = 0; entry < kPrismFaces; ++entry) {
      const double in = light.shadow[entry] * (1.0 - light.reflectance[entry]);
      goesIn += in;
      if (in > 0.0) sum += in * light.cutOff[entry];
    }
    // All but later orders than are told.
    CHECK(sum <= goesIn * (1.0 + 1e-12));
    CHECK(sum > 0.97 * goesIn);
    for (const double order : light.byOrder) CHECK(order > -1e-12);
  }
}
