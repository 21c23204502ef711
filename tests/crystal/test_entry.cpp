// SPDX-License-Identifier: Apache-2.0
#include "crystal/entry.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "crystal/shapes.h"
#include "entry_sampler.h"
#include "math/rotation.h"
#include "random_stream.h"
#include "statistics.h"

using namespace parhelion;

namespace {

double cross2(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

/// The convex hull of points, counter-clockwise (Andrew's monotone chain).
std::vector<Vec2> hullOf(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<Vec2> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t start = hull.size();
    for (const Vec2& p : points) {
      while (hull.size() > start + 1 && cross2(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// A crystal's shadow, found from its vertices alone.
struct Shadow {
  Mat3 frame;  // columns: two directions across the light, then the light's
  std::vector<Vec2> outline;
  double area = 0.0;
  Vec2 centroid{0.0};

  Shadow(const Crystal& crystal, const Vec3& lightDir) : frame(frameAround(lightDir)) {
    std::vector<Vec2> points;
    for (const Vec3& v : crystal.mesh->vertices()) points.push_back(project({v.x, v.y, v.z * crystal.stretch}));
    outline = hullOf(points);
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
      area += 0.5 * cross2(a, b);
      centroid += cross2(a, b) / 6.0 * (a + b);
    }
    centroid /= area;
  }

  Vec2 project(const Vec3& point) const { return Vec2(glm::transpose(frame) * point); }

  // Cells of known area: each triangle from the centroid to a side, cut by rings and by sectors of its side.
  static constexpr int kRings = 5, kSectors = 5;
  int sides() const { return static_cast<int>(outline.size()); }
  int cells() const { return sides() * kRings * kSectors; }
  Vec2 corner(int side) const { return outline[side % sides()] - centroid; }

  int cellOf(const Vec2& point) const {
    const Vec2 p = point - centroid;
    for (int side = 0; side < sides(); ++side) {
      const Vec2 a = corner(side), b = corner(side + 1);
      const double alongA = cross2(p, b) / cross2(a, b), alongB = cross2(a, p) / cross2(a, b);
      if (alongA < 0.0 || alongB < 0.0) continue;
      const double r = alongA + alongB;
      const int ring = std::min(kRings - 1, static_cast<int>(r * r * kRings));
      return (side * kRings + ring) * kSectors + std::min(kSectors - 1, static_cast<int>(alongB / r * kSectors));
    }
    return 0;
  }

  std::vector<double> expected(double hits) const {
    std::vector<double> counts;
    for (int cell = 0; cell < cells(); ++cell) {
      const int side = cell / (kRings * kSectors);
      counts.push_back(hits * 0.5 * cross2(corner(side), corner(side + 1)) / area / (kRings * kSectors));
    }
    return counts;
  }
};

/// The area of a face, from its corners.
double areaOf(const Crystal& crystal, int face) {
  std::vector<Vec3> corners;
  for (const int v : crystal.mesh->faces()[face].vertices)
    corners.push_back(crystal.mesh->vertices()[v] * Vec3(1.0, 1.0, crystal.stretch));
  Vec3 doubled(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    doubled += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return 0.5 * glm::length(doubled);
}

/// How many of `rays` should enter through each face.
std::vector<double> faceShares(const Crystal& crystal, const Vec3& lightDir, double rays) {
  std::vector<double> shares;
  double sum = 0.0;
  for (int face = 0; face < static_cast<int>(crystal.mesh->faces().size()); ++face) {
    shares.push_back(areaOf(crystal, face) * std::max(0.0, -glm::dot(crystal.mesh->faces()[face].normal, lightDir)));
    sum += shares.back();
  }
  for (double& share : shares) share *= rays / sum;
  return shares;
}

Vec3 randomDirection(RandomStream& random) {
  const double azimuth = 2.0 * kPi * random.next();
  return skyDirection(azimuth, std::asin(2.0 * random.next() - 1.0));
}

struct Meshes {
  CrystalMesh prism = hexagonalPrism(1.0), thin = hexagonalPrism(1e-3), pyramid = hexagonalPyramid({0.4, 0.7, 0.2}),
              cut = hexagonalPyramid({0.0, 1.0, 0.5});

  std::vector<Crystal> crystals() const {
    return {{&prism}, {&prism, 0.03}, {&prism, 20.0}, {&thin}, {&pyramid}, {&cut}};
  }
};

constexpr int kDirections = 300;

}  // namespace

TEST_CASE("a stretched prism is the prism of that aspect ratio") {
  const CrystalMesh unit = hexagonalPrism(1.0);
  for (const double aspect : {1e-4, 0.3, 5.0, 1e4}) {
    const CrystalMesh whole = hexagonalPrism(aspect);
    const Crystal stretched{&unit, aspect}, plain{&whole};
    CHECK(stretched.surface() == doctest::Approx(plain.surface()).epsilon(1e-13));
    CHECK(stretched.volume() == doctest::Approx(plain.volume()).epsilon(1e-12));
    for (int face = 0; face < 8; ++face) {
      CHECK(areaOf(stretched, face) == doctest::Approx(areaOf(plain, face)).epsilon(1e-12));
      CHECK(stretched.offset(face) == doctest::Approx(plain.offset(face)).epsilon(1e-13));
    }
  }
}

TEST_CASE("a crystal's projected area is that of the hull of its projected vertices") {
  const Meshes meshes;
  for (const Crystal& crystal : meshes.crystals()) {
    const EntrySampler light(crystal);
    RandomStream random(21, 0, RandomPurpose::path);
    for (int i = 0; i < kDirections; ++i) {
      const Vec3 lightDir = randomDirection(random);
      CHECK(light.projectedArea(lightDir) == doctest::Approx(Shadow(crystal, lightDir).area).epsilon(1e-11));
    }
  }
}

TEST_CASE("projected areas along the axes") {
  const CrystalMesh mesh = hexagonalPrism(1.0);
  const EntrySampler light({&mesh, 3.0});
  const double root3 = std::sqrt(3.0);
  CHECK(light.projectedArea({0, 0, -1}) == doctest::Approx(1.5 * root3).epsilon(1e-14));
  CHECK(light.projectedArea({1, 0, 0}) == doctest::Approx(2.0 * 6.0).epsilon(1e-14));
  CHECK(light.projectedArea({0, 1, 0}) == doctest::Approx(root3 * 6.0).epsilon(1e-14));
}

TEST_CASE("the mean projected area of a convex crystal is a quarter of its surface (Cauchy)") {
  const CrystalMesh unit = hexagonalPrism(1.0);
  const Meshes meshes;
  std::vector<Crystal> crystals = meshes.crystals();
  for (const double aspect : {1e-3, 0.1, 1.0, 10.0, 1e3}) crystals.push_back({&unit, aspect});
  for (const Crystal& crystal : crystals) {
    const EntrySampler light(crystal);
    RandomStream random(22, 0, RandomPurpose::path);
    SampleMean mean;
    for (int i = 0; i < 100000; ++i) mean.add(light.projectedArea(randomDirection(random)));
    CHECK(mean.sigmasFrom(0.25 * crystal.surface()) < kSigmas);
  }
}

TEST_CASE("light enters at a point of a lit face, inside its outline") {
  const Meshes meshes;
  for (const Crystal& crystal : meshes.crystals()) {
    const double size = crystal.mesh->radius() * std::max(1.0, crystal.stretch);
    const EntrySampler light(crystal);
    RandomStream random(23, 0, RandomPurpose::path);
    for (int i = 0; i < 20 * kDirections; ++i) {
      const Vec3 lightDir = randomDirection(random);
      const double u1 = random.next(), u2 = random.next();
      const EntryPoint entry = light.sample(lightDir, u1, u2, random.next());
      const Face& face = crystal.mesh->faces()[entry.face];
      CHECK(glm::dot(face.normal, lightDir) < 0.0);
      CHECK(std::abs(glm::dot(face.normal, entry.point) - crystal.offset(entry.face)) < 1e-14 * size);
      // Within a convex face's outline is within all the other planes.
      for (int other = 0; other < static_cast<int>(crystal.mesh->faces().size()); ++other)
        CHECK(glm::dot(crystal.mesh->faces()[other].normal, entry.point) - crystal.offset(other) < 1e-14 * size);
    }
  }
}

TEST_CASE("the ends of the unit interval still lead to a point of a lit face") {
  const Meshes meshes;
  constexpr double kFirst = 0x1p-53, kLast = 1.0 - 0x1p-53;
  for (const Crystal& crystal : meshes.crystals()) {
    const EntrySampler light(crystal);
    for (const Vec3& lightDir : {Vec3(0, 0, -1), Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.6, 0, -0.8)})
      for (const double u1 : {kFirst, kLast})
        for (const double u2 : {kFirst, kLast})
          for (const double u3 : {kFirst, kLast}) {
            const EntryPoint entry = light.sample(lightDir, u1, u2, u3);
            CHECK(glm::dot(crystal.mesh->faces()[entry.face].normal, lightDir) < 0.0);
            CHECK(std::isfinite(glm::length(entry.point)));
          }
  }
}

TEST_CASE("light enters uniformly over the crystal's shadow, and each lit face takes its share of it") {
  constexpr int kRays = 40000;
  int stream = 0;
  const Meshes meshes;
  for (const Crystal& crystal : meshes.crystals()) {
    const EntrySampler light(crystal);
    for (int direction = 0; direction < 4; ++direction) {
      RandomStream random(24, stream++, RandomPurpose::path);
      const Vec3 lightDir = randomDirection(random);
      const Shadow shadow(crystal, lightDir);
      std::vector<double> hits(shadow.cells(), 0.0), faceHits(crystal.mesh->faces().size(), 0.0);
      SampleMean x, y;
      for (int i = 0; i < kRays; ++i) {
        const double u1 = random.next(), u2 = random.next();
        const EntryPoint entry = light.sample(lightDir, u1, u2, random.next());
        const Vec2 point = shadow.project(entry.point);
        ++faceHits[entry.face];
        ++hits[shadow.cellOf(point)];
        x.add(point.x);
        y.add(point.y);
      }
      CHECK(chiSquareSigma(hits, shadow.expected(kRays)) < kSigmas);
      CHECK(chiSquareSigma(faceHits, faceShares(crystal, lightDir, kRays)) < kSigmas);
      CHECK(x.sigmasFrom(shadow.centroid.x) < kSigmas);
      CHECK(y.sigmasFrom(shadow.centroid.y) < kSigmas);
    }
  }
}
