// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "math/rotation.h"
#include "optics/interface.h"
#include "random_stream.h"

using namespace parhelion;

namespace {

constexpr double kIndex = 1.31;

/// Calls `test(lightDir, normal)` for many pairs in which light falls on the side that the normal points to.
template <class Test>
void forManyRays(const Test& test) {
  for (int i = 0; i < 5000; ++i) {
    RandomStream random(4, i, RandomPurpose::path);
    const double azimuth = 2.0 * kPi * random.next(), elevation = std::asin(2.0 * random.next() - 1.0);
    const double turn = 2.0 * kPi * random.next();
    const Vec3 normal = skyDirection(azimuth, elevation);
    const double cosine = i % 2 ? random.next() : std::pow(10.0, -9.0 * random.next());  // half of them grazing
    const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
    test(frameAround(normal) * Vec3(sine * std::cos(turn), sine * std::sin(turn), -cosine), normal);
  }
}

/// Refracts light that meets a plane with the outward normal `normal`; nothing when totally reflected.
std::optional<Vec3> cross(const Vec3& lightDir, const Vec3& normal, double eta) {
  const double cosTheta_i = std::abs(glm::dot(lightDir, normal));
  const auto face = fresnel<double>(cosTheta_i, eta);
  if (face.cosTheta_t == 0.0) return std::nullopt;
  return refract<double>(lightDir, normal, cosTheta_i, face.cosTheta_t, eta);
}

/// Deviation of a ray that meets a wedge's first face at `theta_i` in the principal section; pi when it cannot leave.
double deviation(double wedge, double theta_i, double index) {
  const double half = 0.5 * wedge;
  const Vec3 first(-std::cos(half), std::sin(half), 0.0), second(std::cos(half), std::sin(half), 0.0);
  const Vec3 along(std::sin(half), std::cos(half), 0.0);  // up the first face
  const Vec3 lightDir = -std::cos(theta_i) * first + std::sin(theta_i) * along;
  const auto inside = cross(lightDir, first, index);
  const auto outside = cross(*inside, -second, 1.0 / index);
  return outside ? angleBetween(lightDir, *outside) : kPi;
}

/// The least deviation over all angles of incidence, by golden section.
double leastDeviation(double wedge, double index) {
  double lo = 0.0, hi = 0.5 * kPi;
  // Start beside the best of a coarse scan: below it some rays cannot leave.
  double best = lo;
  for (double t = lo; t < hi; t += radians(1.0))
    if (deviation(wedge, t, index) < deviation(wedge, best, index)) best = t;
  lo = std::max(0.0, best - radians(1.0));
  hi = std::min(0.5 * kPi, best + radians(1.0));
  constexpr double kGolden = 0.6180339887498949;
  for (int i = 0; i < 60; ++i) {
    const double a = hi - kGolden * (hi - lo), b = lo + kGolden * (hi - lo);
    if (deviation(wedge, a, index) < deviation(wedge, b, index))
      hi = b;
    else
      lo = a;
  }
  return deviation(wedge, 0.5 * (lo + hi), index);
}

}  // namespace

TEST_CASE("a refracted ray is a unit vector in the plane of incidence that obeys Snell's law") {
  forManyRays([](const Vec3& lightDir, const Vec3& normal) {
    for (const double eta : {kIndex, 1.0 / kIndex}) {
      const auto refracted = cross(lightDir, normal, eta);
      if (!refracted) continue;
      CHECK(std::abs(glm::length(*refracted) - 1.0) < 1e-15);
      // The parts along the surface, as vectors, are in the ratio of the indices.
      const Vec3 before = glm::cross(normal, lightDir), after = glm::cross(normal, *refracted);
      CHECK(glm::length(before - eta * after) < 1e-15);
      CHECK(glm::dot(*refracted, normal) < 0.0);
    }
  });
}

TEST_CASE("light is totally reflected exactly where Snell's law has no solution") {
  forManyRays([](const Vec3& lightDir, const Vec3& normal) {
    const double sine = glm::length(glm::cross(normal, lightDir));
    if (std::abs(sine * kIndex - 1.0) < 1e-12) return;
    CHECK(cross(lightDir, normal, 1.0 / kIndex).has_value() == (sine * kIndex < 1.0));
    CHECK(cross(lightDir, normal, kIndex).has_value());
  });
}

TEST_CASE("a refracted ray returns on its own path") {
  forManyRays([](const Vec3& lightDir, const Vec3& normal) {
    const Vec3 inside = *cross(lightDir, normal, kIndex);
    const auto back = cross(-inside, -normal, 1.0 / kIndex);
    const double grazing = -glm::dot(lightDir, normal);
    // At grazing incidence a rounding of the inner ray may make it totally reflected.
    if (grazing > 1e-7) {
      REQUIRE(back.has_value());
      CHECK(glm::distance(*back, -lightDir) < 1e-15 / grazing);
    }
  });
}

TEST_CASE("a reflected ray keeps its length and its angle with the normal, on the other side") {
  forManyRays([](const Vec3& lightDir, const Vec3& normal) {
    const double cosTheta_i = -glm::dot(lightDir, normal);
    const Vec3 reflected = reflect(lightDir, normal, cosTheta_i);
    CHECK(std::abs(glm::length(reflected) - 1.0) < 1e-15);
    CHECK(std::abs(glm::dot(reflected, normal) - cosTheta_i) < 1e-15);
    CHECK(glm::distance(glm::cross(normal, reflected), glm::cross(normal, lightDir)) < 1e-15);
  });
}

TEST_CASE("the least deviations of ice's eight wedges are the radii of its circular halos") {
  struct Halo {
    double wedge, radius;  // degrees, at n = 1.31
  };
  constexpr Halo kHalos[] = {{28.0, 8.953},  {52.396, 18.271}, {56.0, 19.905},   {60.0, 21.839},
                             {62.0, 22.862}, {63.802, 23.819}, {80.247, 34.929}, {90.0, 45.733}};
  for (const Halo& halo : kHalos) {
    INFO("wedge of " << halo.wedge << " degrees");
    CHECK(std::abs(degrees(leastDeviation(radians(halo.wedge), kIndex)) - halo.radius) < 1e-3);
  }
}

TEST_CASE("the 22 degree halo is blue at 22.272, green at 21.915 and red at 21.688 degrees") {
  CHECK(std::abs(degrees(leastDeviation(radians(60), 1.3157)) - 22.272) < 1e-3);
  CHECK(std::abs(degrees(leastDeviation(radians(60), 1.3110)) - 21.915) < 1e-3);
  CHECK(std::abs(degrees(leastDeviation(radians(60), 1.3080)) - 21.688) < 1e-3);
}

TEST_CASE("no light passes a wedge of more than twice the critical angle") {
  const double limit = 2.0 * std::asin(1.0 / kIndex);
  CHECK(leastDeviation(limit - radians(1.0), kIndex) < kPi);
  CHECK(leastDeviation(limit + radians(1.0), kIndex) == kPi);
}
