// SPDX-License-Identifier: Apache-2.0
#include "crystal/mesh/body_union.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "crystal/isometry.h"
#include "crystal/shapes.h"
#include "random_stream.h"

using namespace parhelion;

namespace {

using Bodies = std::vector<std::vector<FacePlane>>;

/// A box between two corners, its faces numbered from `first`.
std::vector<FacePlane> box(const Vec3& low, const Vec3& high, int first = 1) {
  std::vector<FacePlane> planes;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {1.0, -1.0}) {
      Vec3 normal(0.0);
      normal[axis] = side;
      planes.push_back({first++, normal, side > 0.0 ? high[axis] : -low[axis]});
    }
  return planes;
}

double surfaceOf(const CrystalMesh& mesh) { return mesh.surfaceAlongC() + mesh.surfaceAcrossC(); }

/// Each edge of the triangles is there in both senses, as often.
bool isClosed(const CrystalMesh& mesh) {
  std::multiset<std::pair<int, int>> edges;
  for (const Face& face : mesh.faces()) {
    for (const auto& [a, b, c] : face.triangles) edges.insert({{a, b}, {b, c}, {c, a}});
    for (std::size_t i = 0; i < face.vertices.size(); ++i)
      edges.insert({face.vertices[i], face.vertices[(i + 1) % face.vertices.size()]});
  }
  return std::ranges::all_of(edges, [&](const auto& edge) {
    return edges.count(edge) == edges.count({edge.second, edge.first});
  });
}

/// Half-spaces of the bodies of a rosette, by its faces: only what is convex before the union.
Bodies bulletsOf(const RosetteSettings& rosette) {
  RosetteSettings one = rosette;
  one.bullets = 1;
  const CrystalMesh bullet = meshOf(one);
  Bodies bodies;
  for (const Mat3& frame : bulletFrames(rosette.bullets)) {
    bodies.emplace_back();
    for (const Face& face : bullet.faces()) bodies.back().push_back({face.number, frame * face.normal, face.offset});
  }
  return bodies;
}

/// The volume that points in a ball around the origin find in any of some bodies, with its error.
std::pair<double, double> volumeByPoints(const Bodies& bodies, double radius, int points) {
  RandomStream random(5, 0, RandomPurpose::path);
  int inside = 0;
  for (int i = 0; i < points; ++i) {
    const double z = 2.0 * random.next() - 1.0, turn = 2.0 * kPi * random.next(), w = std::sqrt(1.0 - z * z);
    const Vec3 point = radius * std::cbrt(random.next()) * Vec3(w * std::cos(turn), w * std::sin(turn), z);
    inside += std::ranges::any_of(bodies, [&](const std::vector<FacePlane>& planes) {
      return std::ranges::all_of(planes, [&](const FacePlane& p) { return glm::dot(p.normal, point) <= p.distance; });
    });
  }
  const double ball = 4.0 / 3.0 * kPi * radius * radius * radius, share = static_cast<double>(inside) / points;
  return {ball * share, ball * std::sqrt(share * (1.0 - share) / points)};
}

std::string complaintOf(const RosetteSettings& rosette) {
  try {
    static_cast<void>(meshOf(rosette));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("bodies that overlap are one, whose faces end where they meet") {
  const CrystalMesh cross =
      unionOf(Bodies{box({-3, -1, -1}, {3, 1, 1}), box({-1, -3, -1}, {1, 3, 1}, 11), box({-1, -1, -3}, {1, 1, 3}, 21)});
  CHECK(isClosed(cross));
  CHECK(cross.volume() == doctest::Approx(7 * 8.0).epsilon(1e-12));
  CHECK(surfaceOf(cross) == doctest::Approx(6 * 5 * 4.0).epsilon(1e-12));
  // What lies in one plane belongs to the earlier body: the arms' sides are what is left.
  CHECK(cross.faces().size() == 18);
  CHECK(!cross.isConvex());
  const CrystalMesh flat = unionOf(Bodies{box({-3, -1, -1}, {3, 1, 1}), box({-1, -3, -1}, {1, 3, 1}, 11)});
  CHECK(flat.volume() == doctest::Approx(5 * 8.0).epsilon(1e-12));
  CHECK(surfaceOf(flat) == doctest::Approx(2 * 20.0 + 24 * 2.0).epsilon(1e-12));
  // One whole body inside another one leaves the other.
  const CrystalMesh outer = unionOf(Bodies{box({-1, -1, -1}, {1, 1, 1}), box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, 11)});
  CHECK(outer.faces().size() == 6);
  CHECK(outer.volume() == doctest::Approx(8.0).epsilon(1e-12));
}

TEST_CASE("bodies that touch face to face are one, without the faces between, and those that do not touch are two") {
  const CrystalMesh joined = unionOf(Bodies{box({-1, -1, -1}, {1, 1, 1}), box({1, -0.5, -0.5}, {2, 0.5, 0.5}, 11)});
  CHECK(isClosed(joined));
  CHECK(joined.volume() == doctest::Approx(9.0).epsilon(1e-12));
  CHECK(surfaceOf(joined) == doctest::Approx(24.0 + 4.0).epsilon(1e-12));
  const CrystalMesh whole = unionOf(Bodies{box({-1, -1, -1}, {1, 1, 1}), box({1, -1, -1}, {2, 1, 1}, 11)});
  CHECK(surfaceOf(whole) == doctest::Approx(8.0 + 24.0).epsilon(1e-12));
  CHECK(whole.faces().size() == 10);
  const CrystalMesh apart = unionOf(Bodies{box({-1, -1, -1}, {1, 1, 1}), box({1.5, -1, -1}, {2, 1, 1}, 11)});
  CHECK(isClosed(apart));
  CHECK(surfaceOf(apart) == doctest::Approx(24.0 + 12.0).epsilon(1e-12));
  // In a corner or an edge alone nothing passes from one to the other: two bodies again.
  for (const Vec3& shift : {Vec3(2, 2, 2), Vec3(2, 2, 0)})
    CHECK(surfaceOf(unionOf(Bodies{box({-1, -1, -1}, {1, 1, 1}), box(shift - 1.0, shift + 1.0, 11)})) ==
          doctest::Approx(48.0).epsilon(1e-12));
  // A third one that joins them leaves an edge of two walls, which is no surface.
  CHECK_THROWS_AS(unionOf(Bodies{box({-1, -1, -1}, {1, 1, 1}), box({1, 1, -1}, {3, 3, 1}, 11),
                                 box({-1, -1, -2}, {3, 3, -0.5}, 21)}),
                  std::invalid_argument);
}

TEST_CASE("a rosette's volume is that of points in any of its bullets, and its surface is closed") {
  for (int bullets = 2; bullets <= RosetteSettings::kMostBullets; ++bullets)
    for (const auto& [slope, overlap] : {std::pair{28.0, 0.0}, std::pair{28.0, 0.3}, std::pair{40.0, 0.7}}) {
      CAPTURE(bullets);
      CAPTURE(overlap);
      const RosetteSettings rosette{bullets, 0.8, radians(slope), overlap};
      const CrystalMesh mesh = meshOf(rosette);
      CHECK(isClosed(mesh));
      const auto [volume, error] = volumeByPoints(bulletsOf(rosette), mesh.radius(), 40'000);
      CHECK(std::abs(mesh.volume() - volume) < 4.0 * error);
      std::set<int> numbers;
      for (const Face& face : mesh.faces()) CHECK(numbers.insert(face.number).second);
    }
}

TEST_CASE("a rosette of one bullet is a bullet, and bullets that only touch are as many of them") {
  const CrystalMesh bullet = meshOf(RosetteSettings{1, 0.7});
  const CrystalMesh same = meshOf(PyramidSettings{0.7, 0.0, 1.0});
  CHECK(bullet.isConvex());
  CHECK(bullet.volume() == doctest::Approx(same.volume()).epsilon(1e-13));
  CHECK(surfaceOf(bullet) == doctest::Approx(surfaceOf(same)).epsilon(1e-13));
  std::set<int> numbers, expected;
  for (const Face& face : bullet.faces()) numbers.insert(face.number);
  for (const Face& face : same.faces()) expected.insert(face.number);
  CHECK(numbers == expected);
  for (int bullets = 2; bullets <= RosetteSettings::kMostBullets; ++bullets) {
    const CrystalMesh mesh = meshOf(RosetteSettings{bullets, 0.7});
    CHECK(mesh.faces().size() == 13U * static_cast<unsigned>(bullets));
    CHECK(mesh.volume() == doctest::Approx(bullets * bullet.volume()).epsilon(1e-12));
    // They share the vertex in the centre.
    CHECK(mesh.vertices().size() == 12U * static_cast<unsigned>(bullets) + 1);
  }
}

TEST_CASE("bullets are as far apart as they can, and rosettes have the mirrors of it") {
  const double nearest[] = {180.0, 120.0, 109.471, 90.0, 90.0, 72.0, 70.529};
  for (int bullets = 2; bullets <= RosetteSettings::kMostBullets; ++bullets) {
    const std::vector<Mat3> frames = bulletFrames(bullets);
    CHECK(frames.size() == static_cast<std::size_t>(bullets));
    double least = 180.0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      CHECK(glm::determinant(frames[i]) == doctest::Approx(1.0).epsilon(1e-14));
      for (std::size_t j = 0; j < i; ++j)
        least = std::min(least, degrees(std::acos(std::clamp(glm::dot(frames[i][2], frames[j][2]), -1.0, 1.0))));
    }
    CHECK(least == doctest::Approx(nearest[bullets - 2]).epsilon(1e-5));
    for (const double overlap : {0.0, 0.4})
      CHECK(faceImages(meshOf(RosetteSettings{bullets, 1.0, radians(28), overlap}), {.flipsY = true}).has_value());
  }
}

TEST_CASE("bullets that are joined and meet in a corner, too, are refused") {
  // Six blunt tips: each overlaps four others, and between any three of them there is air down to the centre.
  CHECK(complaintOf({6, 1.0, radians(50.0), 0.0}).find("in a corner or an edge alone") != std::string::npos);
  CHECK(complaintOf({6, 1.0, radians(50.0), 0.2}).empty());
}

TEST_CASE("rosettes of any settings are closed or refused") {
  RandomStream random(8, 0, RandomPurpose::path);
  constexpr int kSets = 500;
  int refused = 0;
  for (int i = 0; i < kSets; ++i) {
    RosetteSettings rosette;
    rosette.bullets = 1 + static_cast<int>(RosetteSettings::kMostBullets * random.next());
    rosette.aspect = std::pow(10.0, 8.0 * random.next() - 4.0);
    rosette.slope = radians(random.next() < 0.5 ? 90.0 * random.next() : 10.0 + 60.0 * random.next());
    rosette.overlap = random.next() < 0.2 ? 0.0 : random.next();
    CAPTURE(rosette.bullets);
    CAPTURE(rosette.aspect);
    CAPTURE(degrees(rosette.slope));
    CAPTURE(rosette.overlap);
    double volume = 0.0;
    try {
      const CrystalMesh mesh = meshOf(rosette);
      CHECK(isClosed(mesh));
      volume = mesh.volume();
    } catch (const std::invalid_argument&) {
      // Where tips are blunt and meet in the centre; and bullets that are hundreds of times as long or as wide.
      const double height = 0.5 * std::sqrt(3.0) / std::tan(rosette.slope);
      const double length = rosette.aspect + 0.5 * height;
      CHECK((rosette.overlap == 0.0 || length > 100.0 || length < 0.01));
      ++refused;
      continue;
    }
    // Not less than a bullet, and not more than all.
    const double bullet = meshOf(RosetteSettings{1, rosette.aspect, rosette.slope, rosette.overlap}).volume();
    CHECK(volume >= bullet * (1.0 - 1e-9));
    CHECK(volume <= rosette.bullets * bullet * (1.0 + 1e-9));
  }
  CHECK(refused < kSets / 12);
}
