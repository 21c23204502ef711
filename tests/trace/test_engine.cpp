// SPDX-License-Identifier: Apache-2.0
// Embree and the planes engine must send light through the same faces, ray by ray.
#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/geometric.hpp>

#include "crystals.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

// How far from an edge, as a share of the crystal's size, Embree may take a ray for its neighbour: some digits of
// single precision, a few more where the ray grazes both faces.
constexpr double kNearEdge = 3e-5;

/// Mixes all bits of a word into all others (the finalizer of Murmur3's 64-bit variant).
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ x >> 33) * 0xFF51AFD7ED558CCD;
  x = (x ^ x >> 33) * 0xC4CEB9FE1A85EC53;
  return x ^ x >> 33;
}
std::uint64_t mixed(std::uint64_t before, double next) { return mixed(before ^ std::bit_cast<std::uint64_t>(next)); }

/// A word for each ray of a monochromatic run that is the same when all its light leaves at the same encounters in the
/// same directions with the same energies, to the last bit, after the same length of way. Other faces make other words.
class RayHashes : public Film {
 public:
  explicit RayHashes(std::vector<std::uint64_t>& hashes) : hashes_(hashes) {}

  int add(const TracedRays& traced) override {
    const auto& [queue, exits, members, population, mesh, steps] = traced;
    for (int i = 0; i < exits.count; ++i) {
      const Vec3 dir = exits.lightDir(i);
      std::uint64_t hash = mixed(static_cast<std::uint64_t>(exits.order[i]));
      for (const double x : {exits.energy[i], dir.x, dir.y, dir.z}) hash = mixed(hash, x);
      hashes_[queue.bundle[queue.placeOf(static_cast<int>(exits.ray[i]))]] += hash;
    }
    for (int place = 0; place < queue.count; ++place)
      hashes_[queue.bundle[place]] += mixed(1, queue.internalPath[place]);
    return exits.count;
  }
  // Threads trace different rays, so that all can write to one array.
  std::unique_ptr<Film> forThread() override { return std::make_unique<RayHashes>(hashes_); }
  void merge(Film&) override {}

 private:
  std::vector<std::uint64_t>& hashes_;
};

/// How far inside the plane of a face a point of the crystal is, crystal sizes.
double depthBehind(const Crystal& crystal, int face, const Vec3& point) {
  return std::abs(crystal.offset(face) - glm::dot(crystal.mesh->faces()[face].normal, point)) /
         (crystal.mesh->radius() * std::max(1.0, crystal.stretch));
}
int faceOfNumber(const CrystalMesh& mesh, int number) {
  const auto& faces = mesh.faces();
  return static_cast<int>(std::ranges::find(faces, number, &Face::number) - faces.begin());
}

/// What two engines made of the same rays.
struct Comparison {
  std::uint64_t rays = 0, different = 0;
  std::uint64_t rescued = 0;  // encounters that Embree missed and the planes decided
  double worst = 0.0;         // distance from an edge where they part, crystal sizes

  /// Traces rays of a cloud of one population by both engines, and looks closely at those that come out differently.
  void run(const Cloud& cloud, std::uint64_t count) {
    const auto byEmbree = hashesOf(cloud, Engine::embree, count), byPlanes = hashesOf(cloud, Engine::planes, count);
    const Intersectors embree = makeIntersectors(cloud, Engine::embree),
                       planes = makeIntersectors(cloud, Engine::planes);
    RaySource source(cloud, {}, 1);
    LightPath a, b;
    a.recordEncounters = b.recordEncounters = true;
    rays += count;
    for (std::uint64_t index = 0; index < count; ++index) {
      if (byEmbree[index] == byPlanes[index]) continue;
      ++different;
      followRay(source, embree, {}, index, a);
      followRay(source, planes, {}, index, b);
      compare(a, b);
    }
  }

  std::vector<std::uint64_t> hashesOf(const Cloud& cloud, Engine engine, std::uint64_t count) {
    std::vector<std::uint64_t> hashes(count);
    RayHashes tally(hashes);
    const TraceReport report = traceRays(cloud, {.rays = count, .engine = engine}, 0, tally);
    CHECK(report.energy.lost.value() == 0.0);
    rescued += report.rescued;
    return hashes;
  }

  /// The first faces in which two paths differ, which must share an edge that the ray passes.
  void compare(const LightPath& embree, const LightPath& planes) {
    const std::size_t common = std::min(embree.encounters.size(), planes.encounters.size());
    for (std::size_t k = 0; k < common; ++k) {
      const Encounter &a = embree.encounters[k], &b = planes.encounters[k];
      if (a.faceNumber != b.faceNumber) {
        const Crystal& crystal = planes.incident.crystal;
        worst = std::max(worst, depthBehind(crystal, faceOfNumber(*crystal.mesh, a.faceNumber), b.point));
        return;
      }
      // One and the same face means the same bits, so that nothing but the choice of a face can set paths apart.
      REQUIRE(a.point == b.point);
      REQUIRE(a.energyLeaving == b.energyLeaving);
      REQUIRE(a.energyStaying == b.energyStaying);
    }
    FAIL("the engines part without a face that differs, ray ", embree.incident.index);
  }
};

PopulationSettings pyramids(double aspect, double upper, double lower) {
  return {"pyramids", 1.0, PyramidSettings{aspect, upper, lower}, RandomOrientation{}};
}

}  // namespace

TEST_CASE("Embree and the planes engine send ten million rays through the same faces, edges aside") {
  std::vector<PopulationSettings> kinds;
  for (const double aspect : {0.01, 0.1, 0.3, 1.0, 3.0, 10.0, 100.0}) kinds.push_back(prismPopulation(aspect));
  // Stretched from one mesh as it is traced.
  kinds.push_back(prismPopulation(1.0));
  kinds.back().shape = PrismSettings{UniformRange{0.01, 100.0}};
  for (const auto& pyramid : {pyramids(0.4, 0.5, 0.5), pyramids(0.3, 0.9, 0.2), pyramids(0.0, 1.0, 1.0)})
    kinds.push_back(pyramid);

  Comparison all;
  for (const PopulationSettings& kind : kinds) all.run(simpleCloud({kind}), 10'000'000 / kinds.size() + 1);
  MESSAGE(all.different << " of " << all.rays << " rays part, within " << all.worst << " of an edge; Embree missed "
                        << all.rescued << " faces");
  CHECK(all.rays >= 10'000'000);
  CHECK(all.worst < kNearEdge);
  // A ray meets four or five faces, each within 1e-7, Embree's digits, of an edge in about one of ten million.
  CHECK(all.different + all.rescued < 20);
}

TEST_CASE("where light is aimed so near an edge that Embree and the planes part, both faces end there") {
  std::uint64_t rays = 0, different = 0;
  double worst = 0.0;
  for (const CrystalMesh& mesh : {hexagonalPrism(0.01), hexagonalPrism(1.0), hexagonalPrism(100.0),
                                  hexagonalPyramid({}), hexagonalPyramid({0.3, 0.9, 0.2})}) {
    const Crystal crystal{&mesh};
    const EntrySampler light(crystal);
    const Intersector embree = intersectorOf(mesh, Engine::embree), planes = intersectorOf(mesh, Engine::planes);
    for (int i = 0; i < 100'000; ++i) {
      RandomStream random(41, i, RandomPurpose::incidence);
      const EntryPoint from = light.sample(randomDirection(random), random.next(), random.next(), random.next());
      const auto& ring = mesh.faces()[i % mesh.faces().size()].vertices;
      const std::size_t corner = static_cast<std::size_t>(random.next() * static_cast<double>(ring.size()));
      const Vec3 a = mesh.vertices()[ring[corner]], b = mesh.vertices()[ring[(corner + 1) % ring.size()]];
      const Vec3 beside = std::pow(10.0, -5.0 - 3.0 * random.next()) * mesh.radius() * randomDirection(random);
      const Vec3 lightDir = glm::normalize(glm::mix(a, b, random.next()) + beside - from.point);
      if (glm::dot(mesh.faces()[from.face].normal, lightDir) > -1e-3) continue;  // not into the crystal
      const auto one = nextFace(embree, crystal, from.point, lightDir, from.face);
      const auto other = nextFace(planes, crystal, from.point, lightDir, from.face);
      REQUIRE(one);
      REQUIRE(other);
      ++rays;
      if (one->face == other->face) continue;
      ++different;
      worst = std::max(worst, depthBehind(crystal, one->face, from.point + other->distance * lightDir));
    }
  }
  MESSAGE(different << " of " << rays << " rays part, within " << worst << " of an edge");
  CHECK(different > 100);
  CHECK(worst < kNearEdge);
}
