// SPDX-License-Identifier: Apache-2.0
#include "trace/concave_crystal.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "crystal/mesh/mesh_from_obj.h"
#include "crystal/objs.h"
#include "crystal/shapes/rosette.h"
#include "random_stream.h"

using namespace parhelion;

namespace {

/// What meets a mesh next by all its triangles in double precision, whatever the side: Möller and Trumbore 1997. Knows
/// nothing of faces but which of them the ray starts on.
struct Oracle {
  explicit Oracle(const CrystalMesh& mesh) {
    for (int f = 0; f < static_cast<int>(mesh.faces().size()); ++f)
      for (const auto& [a, b, c] : mesh.faces()[f].triangles)
        triangles.push_back({mesh.vertices()[a], mesh.vertices()[b], mesh.vertices()[c], f});
  }

  struct Triangle {
    Vec3 a, b, c;
    int face;
  };
  std::vector<Triangle> triangles;

  struct Met {
    int face = kNoFace;
    double distance = 1e300;
  };
  Met next(const Vec3& point, const Vec3& dir, int leftFace) const {
    Met met;
    for (const auto& [a, b, c, face] : triangles) {
      if (face == leftFace) continue;
      const Vec3 ab = b - a, ac = c - a, p = glm::cross(dir, ac), from = point - a;
      const double volume = glm::dot(ab, p), u = glm::dot(from, p) / volume;
      if (!(u >= 0.0 && u <= 1.0)) continue;
      const Vec3 q = glm::cross(from, ab);
      const double v = glm::dot(dir, q) / volume, t = glm::dot(ac, q) / volume;
      if (v >= 0.0 && u + v <= 1.0 && t >= 0.0 && t < met.distance) met = {face, t};
    }
    return met;
  }

  /// Distance of a point from the nearest edge of any triangle.
  double toEdge(const Vec3& point) const {
    double nearest = 1e300;
    for (const Triangle& t : triangles)
      for (const auto& [p, q] : {std::pair{t.a, t.b}, std::pair{t.b, t.c}, std::pair{t.c, t.a}}) {
        const double along = glm::clamp(glm::dot(point - p, q - p) / glm::dot(q - p, q - p), 0.0, 1.0);
        nearest = std::min(nearest, glm::length(point - p - along * (q - p)));
      }
    return nearest;
  }
};

Vec3 direction(RandomStream& random) {
  const double z = 2.0 * random.next() - 1.0, turn = 2.0 * kPi * random.next(), r = std::sqrt(1.0 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

/// Compares engine and oracle along rays that meet a crystal and then go any way at each face.
void compare(const CrystalMesh& mesh, int rays) {
  // Single precision puts a ray's start this far from where it is, over the crystal's size of about 2.
  constexpr double kNearEdge = 2e-6;
  const EmbreeDevice device;
  const ConcaveCrystal crystal(device, mesh);
  const Oracle oracle(mesh);
  RandomStream random(11, 0, RandomPurpose::path);
  long long steps = 0, nearEdges = 0, wrong = 0, entered = 0;
  for (int ray = 0; ray < rays; ++ray) {
    Vec3 dir = direction(random);
    const Vec3 side = glm::normalize(glm::cross(dir, std::abs(dir.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0)));
    const double r = mesh.radius() * std::sqrt(random.next()), turn = 2.0 * kPi * random.next();
    Vec3 point = r * (std::cos(turn) * side + std::sin(turn) * glm::cross(dir, side)) - 2.0 * mesh.radius() * dir;
    int face = kNoFace;
    Side on = Side::outside;
    for (int encounter = 0; encounter < 12; ++encounter) {
      const Oracle::Met expected = oracle.next(point, dir, face);
      const auto met = crystal.nextFace(point, dir, face, on);
      ++steps;
      const bool agree = met ? met->face == expected.face : expected.face == kNoFace;
      if (!agree) {
        const Vec3 there = point + (expected.face != kNoFace ? expected.distance : met->distance) * dir;
        const bool isNear = std::min({oracle.toEdge(point), oracle.toEdge(there),
                                      met ? oracle.toEdge(point + met->distance * dir) : 1e300}) < kNearEdge;
        ++(isNear ? nearEdges : wrong);
        break;
      }
      if (!met) break;
      if (std::abs(met->distance - expected.distance) > 1e-9) ++wrong;
      entered += encounter == 0;
      point += met->distance * dir;
      face = met->face;
      // Inside or outside of this face, anywhere.
      on = random.next() < 0.7 ? Side::inside : Side::outside;
      dir = direction(random);
      const Vec3& normal = mesh.faces()[face].normal;
      if ((glm::dot(dir, normal) > 0.0) != (on == Side::outside)) dir = -dir;
    }
  }
  CHECK(entered > rays / 10);
  CHECK(steps > 2LL * rays);
  CHECK(wrong == 0);
  CHECK(static_cast<double>(nearEdges) < 2e-5 * static_cast<double>(steps));
}

}  // namespace

TEST_CASE(
    "a crystal that is not convex has the same face sequences as by brute force in double precision, but within "
    "2e-6 of an edge") {
  compare(prismWithEnds(1.5, {{0.4, 0.8}}, {{0.6, 0.5}}), 60'000);
  compare(prismWithEnds(0.2, {{0.9, 0.95}}, {}), 60'000);
  compare(meshFromObj(halvesOf(1.0, 0.01)), 60'000);
  compare(prismWithEnds(1.5, {{}, {2.5, 0.1}}, {{0.4, 0.7}, {}}), 60'000);
  compare(notchedPrism(0.3, {0.6, 0.4}), 60'000);
  compare(meshOf(RosetteSettings{6, 0.7, radians(28.0), 0.0}), 60'000);
  compare(meshOf(RosetteSettings{4, 0.6, radians(35.0), 0.4}), 60'000);
}

TEST_CASE("faces on the hull are those that light which leaves them has left for good") {
  const CrystalMesh mesh = prismWithEnds(1.5, {{0.4, 0.8}}, {{0.4, 0.8}});
  const EmbreeDevice device;
  const ConcaveCrystal crystal(device, mesh);
  for (int f = 0; f < static_cast<int>(mesh.faces().size()); ++f)
    CHECK(crystal.isOnHull(f) == (mesh.faces()[f].number <= 8));
}
