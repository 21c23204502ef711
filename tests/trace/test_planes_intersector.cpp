// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "crystals.h"

using namespace parhelion;
using namespace parhelion::test;

TEST_CASE("the planes engine finds the face that a plain search of all planes finds") {
  const CrystalMesh unit = hexagonalPrism(1.0), pyramid = hexagonalPyramid({}),
                    skew = hexagonalPyramid({0.3, 0.9, 0.2});
  for (const Crystal& crystal :
       {Crystal{&unit}, Crystal{&unit, 0.02}, Crystal{&unit, 70.0}, Crystal{&pyramid}, Crystal{&skew}}) {
    const EntrySampler light(crystal);
    const PlanesIntersector engine(*crystal.mesh);
    for (int i = 0; i < 50'000; ++i) {
      RandomStream random(31, i, RandomPurpose::incidence);
      const Vec3 lightDir = randomDirection(random);
      const EntryPoint from = light.sample(lightDir, random.next(), random.next(), random.next());
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
