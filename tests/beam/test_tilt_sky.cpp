// SPDX-License-Identifier: Apache-2.0
// What skies of all tilts are made of: cosines around a ring, points of the sun's disc, light shared over cells.
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "beam/band_light.h"
#include "beam/cosine_table.h"
#include "beam/light_class.h"
#include "beam/sun_points.h"
#include "beam/triangle_cells.h"

using namespace parhelion;

TEST_CASE("cosines of a ring give its cells back") {
  constexpr int kCells = 88;
  const CosineTable table(kCells);
  std::mt19937_64 random(7);
  std::vector<std::array<double, 2>> cells;
  for (int k = 0; k < kCells; ++k)
    cells.push_back({static_cast<double>(random() % 1000), static_cast<double>(random() % 1000)});
  std::vector<CosineTable::CellPair<2>> pairs;
  for (int k = 0; k < kCells / 2; ++k) {
    CosineTable::CellPair<2> pair{k, {}, {}};
    for (std::size_t c = 0; c < 2; ++c) {
      const double a = cells[static_cast<std::size_t>(k)][c], b = cells[static_cast<std::size_t>(kCells - 1 - k)][c];
      pair.sum[c] = static_cast<float>(a + b);
      pair.difference[c] = static_cast<float>(a - b);
    }
    pairs.push_back(pair);
  }
  const int room = table.room(kCells);
  std::vector<float> orders(static_cast<std::size_t>(4 * room));
  table.analyse<2>(pairs, room, orders.data());
  // Of the sums over cells, twice the mean is the amplitude; of order 0, the mean itself.
  for (int part = 0; part < 4; ++part)
    for (int k = 0; k < room; ++k) {
      const int order = 2 * k + part % 2;
      orders[static_cast<std::size_t>(part * room + k)] *=
          order >= kCells ? 0.0F : (order == 0 ? 1.0F : 2.0F) / static_cast<float>(kCells);
    }
  std::vector<float> back(4 * kCells);
  table.synthesise<2>(orders.data(), room, back.data());
  for (int k = 0; k < kCells; ++k)
    for (int c = 0; c < 2; ++c)
      CHECK(static_cast<double>(back[static_cast<std::size_t>(4 * k + c)]) ==
            doctest::Approx(cells[static_cast<std::size_t>(k)][static_cast<std::size_t>(c)]).epsilon(1e-4));
}

TEST_CASE("points of the sun's disc have its moments") {
  // An even disc: all means up to the degree 5 are exact, to the flatness of so small a disc.
  constexpr double kRadius = 0.0046;
  for (const double elevation : {5.0, 40.0, 89.9}) {
    CAPTURE(elevation);
    const double h = elevation / 180.0 * kPi;
    const Vec3 centre(std::cos(h), 0.0, std::sin(h)), up(-std::sin(h), 0.0, std::cos(h)), left(0.0, 1.0, 0.0);
    const SunFace sun{centre, kRadius, [](double) { return 1.0; }};
    double weight = 0.0, xx = 0.0, yy = 0.0, xxyy = 0.0, x4 = 0.0, x1 = 0.0, y1 = 0.0;
    for (const SunRow& row : sunRows(sun, 3))
      for (const SunRow::Point& point : row.points) {
        const double c = std::cos(point.azimuth), s = std::sin(point.azimuth);
        const Vec3 toSun(c * row.toSun.x - s * row.toSun.y, s * row.toSun.x + c * row.toSun.y, row.toSun.z);
        CHECK(glm::length(toSun) == doctest::Approx(1.0).epsilon(1e-9));
        const double x = glm::dot(toSun, left) / kRadius, y = glm::dot(toSun, up) / kRadius;
        weight += point.weight;
        x1 += point.weight * x;
        y1 += point.weight * y;
        xx += point.weight * x * x;
        yy += point.weight * y * y;
        xxyy += point.weight * x * x * y * y;
        x4 += point.weight * x * x * x * x;
      }
    CHECK(weight == doctest::Approx(1.0).epsilon(1e-9));
    CHECK(std::abs(x1) < 1e-9);
    CHECK(std::abs(y1) < 4e-3);  // a row of one elevation is an arc
    CHECK(xx == doctest::Approx(0.25).epsilon(0.005));
    CHECK(yy == doctest::Approx(0.25).epsilon(0.005));
    CHECK(xxyy == doctest::Approx(1.0 / 24.0).epsilon(0.01));
    CHECK(x4 == doctest::Approx(0.125).epsilon(0.01));
  }
}

TEST_CASE("a point sun is one point") {
  const std::vector<SunRow> rows = sunRows({Vec3(1.0, 0.0, 0.0), 0.0, {}}, 3);
  REQUIRE(rows.size() == 1);
  REQUIRE(rows[0].points.size() == 1);
  CHECK(rows[0].points[0].weight == 1.0);
}

TEST_CASE("light of a triangle is shared over the cells under it") {
  // A square of two triangles, 2 by 2 cells from (0.5, 0.5) on: whole cells have four times the light of its corners.
  double cells[4][4]{};
  const auto add = [&](int x, int y, double light) { cells[y][x] += light; };
  shareOverCells({0.5, 0.5, 1.0}, {2.5, 0.5, 1.0}, {0.5, 2.5, 1.0}, 4, 4, add);
  shareOverCells({2.5, 0.5, 1.0}, {2.5, 2.5, 1.0}, {0.5, 2.5, 1.0}, 4, 4, add);
  CHECK(cells[1][1] == doctest::Approx(0.5));
  CHECK(cells[0][0] == doctest::Approx(0.125));
  CHECK(cells[0][1] == doctest::Approx(0.25));
  CHECK(cells[2][2] == doctest::Approx(0.125));
  CHECK(cells[3][3] == 0.0);
}

TEST_CASE("rows of a grid have the same light to the bit, whichever rows there are") {
  constexpr int kWidth = 12, kHeight = 16, kFirst = 5, kEnd = 11;
  std::mt19937_64 random(11);
  const auto place = [&](double size) { return 1.4 * size * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.15); };
  double all[kHeight][kWidth]{}, some[kHeight][kWidth]{};
  for (int k = 0; k < 400; ++k) {
    // Every other one is thin.
    const double wide = k % 2 ? 1.0 : 0.02;
    const LitPlace a{place(kWidth), place(kHeight), 1.0}, b{a.x + wide * place(kWidth), place(kHeight), 0.3},
        c{a.x - wide * place(kWidth), place(kHeight), 2.0};
    shareOverCells(a, b, c, kWidth, kHeight, [&](int x, int y, double light) { all[y][x] += light; });
    shareOverCells(
        a, b, c, kWidth, kEnd, [&](int x, int y, double light) { some[y][x] += light; }, kFirst);
  }
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) CHECK(some[y][x] == (y >= kFirst && y < kEnd ? all[y][x] : 0.0));
}

TEST_CASE("a mesh covers those of fewer rings and orders, and no other") {
  const BandMesh mesh{40, 100, 100, 10, 90, 64.0};
  const auto covered = [&](const auto& change) {
    BandMesh other = mesh;
    change(other);
    return mesh.covers(other);
  };
  CHECK(mesh.covers(mesh));
  CHECK(covered([](BandMesh& other) { other.first = 11; }));
  CHECK(covered([](BandMesh& other) { other.end = 80; }));
  CHECK(covered([](BandMesh& other) { other.orders = 32.0; }));
  CHECK_FALSE(covered([](BandMesh& other) { other.first = 9; }));
  CHECK_FALSE(covered([](BandMesh& other) { other.end = 91; }));
  CHECK_FALSE(covered([](BandMesh& other) { other.orders = 96.0; }));
  CHECK_FALSE(covered([](BandMesh& other) { other.bands = 38; }));
}

TEST_CASE("light right across c, and along planes of symmetry, is finite whatever was in memory before") {
  PrismTracer tracer(PrismSection(), 1.3, 1.31, 1e-5);
  for (const double zeta : {0.0, 0.5 * kPi, 0.5 * kPi * 416 / 416.0})
    for (const double phi : {0.0, kPi / 12.0, kPi / 6.0}) {
      CAPTURE(zeta);
      CAPTURE(phi);
      PrismLight light;
      for (auto& arrivals : light.arrived)
        for (auto& exits : arrivals) exits.fill(std::numeric_limits<double>::infinity());
      traceAt(tracer, phi, zeta, kPi / 12.0, light);
      double met = 0.0;
      forEachClass(light, [&](int, double light_) { met += light_; });
      CHECK(std::isfinite(met));
      CHECK(met > 0.0);
    }
}
