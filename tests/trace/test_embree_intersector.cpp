// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <string>

#include <glm/geometric.hpp>

#include "crystals.h"
#include "trace/embree_intersector.h"

using namespace parhelion;
using namespace parhelion::test;

TEST_CASE("Embree and the planes agree on the next face, edges aside") {
  const EmbreeDevice device;
  for (const EmbreeMode mode : {EmbreeMode::fast, EmbreeMode::robust})
    for (const double aspect : {0.01, 0.1, 1.0, 10.0, 100.0}) {
      // One unit prism serves every aspect ratio; here it is stretched, elsewhere built at its aspect.
      const CrystalMesh unit = hexagonalPrism(1.0);
      const Crystal crystal{&unit, aspect};
      const EntrySampler light(crystal);
      const EmbreeIntersector engine(device, unit, mode);
      int wrong = 0;
      for (int i = 0; i < 50'000; ++i) {
        RandomStream random(21, i, RandomPurpose::incidence);
        const Vec3 lightDir = randomDirection(random);
        const EntryPoint from = light.sample(lightDir, random.next(), random.next(), random.next());
        const auto hit = engine.nextFace(crystal, from.point, lightDir, from.face);
        const auto truth = nextFaceByPlanes(crystal, from.point, lightDir, from.face);
        REQUIRE(hit);
        REQUIRE(truth);
        REQUIRE_FALSE(hit->rescued);
        if (hit->face == truth->face) {
          REQUIRE(hit->distance == truth->distance);
          continue;
        }
        ++wrong;
        // Where they differ the ray passes an edge within single precision: both faces are met at the same place.
        const double size = std::max(1.0, aspect);
        REQUIRE(std::abs(hit->distance - truth->distance) < 1e-5 * size);
      }
      CHECK(wrong <= 5);
    }
}

TEST_CASE("packets that are not full are answered on machines of all registers, whatever is in the rest of the pool") {
  const CrystalMesh mesh = hexagonalPrism(1.0);
  for (const char* isa : {"isa=sse2", "isa=sse4.2", "isa=avx", "isa=avx2", ""}) {  // Embree takes what there is of them
    CAPTURE(isa);
    const EmbreeDevice device(isa);
    const EmbreeIntersector engine(device, mesh, EmbreeMode::fast);
    RayPool pool;
    const double nothing = std::nan("");
    for (auto* rows : {pool.point, pool.lightDir})
      for (int axis = 0; axis < 3; ++axis) rows[axis].fill(nothing);
    pool.stretch.fill(0.0);
    pool.face.fill(0.0);
    pool.active = 3;
    for (int i = 0; i < pool.active; ++i) {
      for (auto* rows : {pool.point, pool.lightDir})
        for (int axis = 0; axis < 3; ++axis) rows[axis][i] = 0.0;
      pool.stretch[i] = 1.0;
      pool.lightDir[2][i] = i == 1 ? -1.0 : 1.0;
    }
    pool.face.fill(7.0);  // none that is met here
    engine.nameFaces(pool);
    for (int i = 0; i < pool.active; ++i)
      CHECK(mesh.faces()[static_cast<std::size_t>(pool.nextFace[i])].number == (i == 1 ? 2 : 1));
  }
}

TEST_CASE("a memory limit that a build exceeds becomes one clear error") {
  const CrystalMesh mesh = hexagonalPrism(1.0);
  std::string message;
  try {
    const EmbreeDevice device("", 64);
    const EmbreeIntersector engine(device, mesh, EmbreeMode::fast);
  } catch (const std::runtime_error& error) {
    message = error.what();
  }
  CHECK(message.find("Embree") != std::string::npos);
  CHECK(message.find("out of memory") != std::string::npos);
  CHECK(message.find('\n') == std::string::npos);
}

TEST_CASE("a device that Embree cannot make becomes one clear error") {
  // An Embree without any instruction set it may use makes no device.
  CHECK_THROWS_WITH_AS(EmbreeDevice("verbose=bad,isa=nonesuch"), doctest::Contains("Embree"), std::runtime_error);
}
