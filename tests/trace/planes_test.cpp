// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "crystals.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

// How far from an edge, as a share of the crystal's size, Embree may take a ray for its neighbour: some digits of
// single precision, a few more where the ray grazes both faces.
constexpr double kNearEdge = 3e-5;

/// What two engines made of the same rays.
struct Comparison {
  std::uint64_t rays = 0, hits = 0, different = 0;
  double worst = 0.0;  // distance from an edge where they part, crystal sizes

  /// Follows the rays of a cloud of one population by both engines until their faces differ.
  void run(const Cloud& cloud, int count) {
    const Engines embree = makeEngines(cloud, Engine::embree), planes = makeEngines(cloud, Engine::planes);
    RaySource source(cloud, {}, 256);
    LightPath a, b;
    a.recordEncounters = b.recordEncounters = true;
    for (int i = 0; i < count; ++i) {
      followRay(source, embree, {}, i, a);
      b.incident = a.incident;
      followLight(planes[0], {}, b);
      compare(a, b);
    }
  }

  void compare(const LightPath& embree, const LightPath& planes) {
    ++rays;
    const std::size_t common = std::min(embree.encounters.size(), planes.encounters.size());
    for (std::size_t k = 0; k < common; ++k, ++hits) {
      if (embree.encounters[k].faceNumber == planes.encounters[k].faceNumber) {
        // One and the same face means the same bits, so that nothing but the choice of a face can set paths apart.
        REQUIRE(embree.encounters[k].point == planes.encounters[k].point);
        REQUIRE(embree.encounters[k].energyLeaving == planes.encounters[k].energyLeaving);
        continue;
      }
      ++different;
      worst = std::max(worst, distanceFromEdge(planes, planes.encounters[k], embree.encounters[k].faceNumber));
      return;
    }
    REQUIRE(embree.encounters.size() == planes.encounters.size());
  }

  /// How far inside the plane of another face a ray meets its face.
  static double distanceFromEdge(const LightPath& path, const Encounter& at, int otherNumber) {
    const Crystal& crystal = path.incident.crystal;
    const auto& faces = crystal.mesh->faces();
    for (int face = 0; face < static_cast<int>(faces.size()); ++face)
      if (faces[face].number == otherNumber)
        return std::abs(crystal.offset(face) - glm::dot(faces[face].normal, at.point)) /
               (crystal.mesh->radius() * std::max(1.0, crystal.stretch));
    return INFINITY;
  }
};

PopulationSettings pyramids(double aspect, double upper, double lower) {
  return {"pyramids", 1.0, PyramidSettings{aspect, upper, lower}, RandomOrientation{}};
}

}  // namespace

TEST_CASE("Embree and the planes engine follow a million rays through the same faces, edges aside") {
  std::vector<PopulationSettings> kinds;
  for (const double aspect : {0.01, 0.1, 0.3, 1.0, 3.0, 10.0, 100.0}) kinds.push_back(prismPopulation(aspect));
  // Stretched from one mesh as it is traced.
  kinds.push_back(prismPopulation(1.0));
  kinds.back().shape = PrismSettings{UniformRange{0.01, 100.0}};
  for (const auto& pyramid : {pyramids(0.4, 0.5, 0.5), pyramids(0.3, 0.9, 0.2), pyramids(0.0, 1.0, 1.0)})
    kinds.push_back(pyramid);

  Comparison all;
  for (const PopulationSettings& kind : kinds) all.run(simpleCloud({kind}), 100'000);
  MESSAGE(all.different << " of " << all.rays << " rays part, after " << all.hits << " hits in common, within "
                        << all.worst << " of an edge");
  CHECK(all.rays >= 1'000'000);
  CHECK(all.worst < kNearEdge);
  CHECK(all.different < all.rays / 10'000);
}

TEST_CASE("the planes engine finds the face that a plain search of all planes finds") {
  const CrystalMesh unit = hexagonalPrism(1.0), pyramid = hexagonalPyramid({}),
                    skew = hexagonalPyramid({0.3, 0.9, 0.2});
  for (const Crystal& crystal :
       {Crystal{&unit}, Crystal{&unit, 0.02}, Crystal{&unit, 70.0}, Crystal{&pyramid}, Crystal{&skew}}) {
    const PlanesIntersector engine(*crystal.mesh);
    for (int i = 0; i < 50'000; ++i) {
      RandomStream random(31, i, RandomPurpose::incidence);
      const Vec3 lightDir = randomDirection(random);
      const EntryPoint from = sampleEntry(crystal, lightDir, random.next(), random.next(), random.next());
      const auto hit = engine.nextFace(crystal, from.point, lightDir, from.face);
      const auto truth = nextFaceByPlanes(crystal, from.point, lightDir, from.face);
      REQUIRE(hit);
      REQUIRE(hit->face == truth->face);
      REQUIRE(hit->distance == truth->distance);
      REQUIRE_FALSE(hit->rescued);
    }
  }
}

TEST_CASE("light along a face is not taken for light that meets it, on which side ever rounding puts the point") {
  const CrystalMesh mesh = hexagonalPrism(1.0);
  const PlanesIntersector engine(mesh);
  // Face 1, the upper basal, at height 1; face 3's normal is +x.
  for (const double height : {std::nextafter(1.0, 0.0), 1.0, std::nextafter(1.0, 2.0)}) {
    const auto hit = engine.nextFace({&mesh}, Vec3(0.0, 0.0, height), Vec3(1.0, 0.0, 0.0), kNoFace);
    REQUIRE(hit);
    CHECK(mesh.faces()[hit->face].number == 3);
  }
  CHECK_FALSE(engine.nextFace({&mesh}, Vec3(0.0), Vec3(NAN), kNoFace));
}
