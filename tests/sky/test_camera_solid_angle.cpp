// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <string>

#include "math/rotation.h"
#include "sky/camera.h"
#include "sky/look_at.h"

namespace parhelion {
namespace {

CameraSettings settings(Projection projection, double fovDegrees, int width, int height, double circleDegrees = 0.0) {
  CameraSettings s = test::lookAt(projection, 0.0, 90.0, 0.0, fovDegrees, width, height);
  s.imageCircle = radians(circleDegrees);
  return s;
}

double total(const CameraSettings& s) {
  const std::vector<double> all = Camera(s).solidAngles();
  return std::accumulate(all.begin(), all.end(), 0.0);
}

/// d Omega / d A in the picture (sr per square pixel) from the definition of the projection.
double density(const Camera& camera, double x, double y) {
  const double f = camera.focalLength();
  const double dx = (x - 0.5 * camera.width()) / f, dy = (y - 0.5 * camera.height()) / f;
  const double r = std::hypot(dx, dy);
  switch (camera.settings().projection) {
    case Projection::rectilinear:
      return std::pow(1.0 + r * r, -1.5) / (f * f);
    case Projection::fisheyeEqualArea:
      return 1.0 / (f * f);
    case Projection::fisheyeEquidistant:
      return (r > 0.0 ? std::sin(r) / r : 1.0) / (f * f);
    case Projection::fisheyeStereographic:
      return std::pow(1.0 + 0.25 * r * r, -2.0) / (f * f);
    case Projection::fisheyeOrthographic:
      return 1.0 / (std::sqrt(1.0 - r * r) * f * f);
    default:
      break;
  }
  return std::cos(dy) / (f * f);
}

constexpr std::array kNode = {-0.93246951420315203, -0.66120938646626451, -0.23861918608319691,
                              0.23861918608319691,  0.66120938646626451,  0.93246951420315203};
constexpr std::array kWeight = {0.17132449237917035, 0.36076157304813861, 0.46791393457269104,
                                0.46791393457269104, 0.36076157304813861, 0.17132449237917035};

/// Six-point Gauss-Legendre of f over [a, b] in `panels` equal panels.
template <typename Function>
double gauss(Function f, double a, double b, int panels) {
  const double half = 0.5 * (b - a) / panels;
  double sum = 0.0;
  for (int p = 0; p < panels; ++p) {
    for (std::size_t k = 0; k < kNode.size(); ++k) sum += kWeight[k] * f(a + half * (2 * p + 1 + kNode[k]));
  }
  return sum * half;
}

double quadrature(const Camera& camera, int x, int y, int panels) {
  return gauss([&](double v) { return gauss([&](double u) { return density(camera, u, v); }, x, x + 1, panels); }, y,
               y + 1, panels);
}

}  // namespace

TEST_CASE("the pixels of an all-sky fisheye add up to the hemisphere, of a whole-sphere fisheye to the sphere") {
  for (const Projection projection : {Projection::fisheyeEqualArea, Projection::fisheyeEquidistant,
                                      Projection::fisheyeStereographic, Projection::fisheyeOrthographic}) {
    CAPTURE(std::string(nameOf(projection)));
    for (const int size : {1, 2, 7, 64, 301, 512}) {
      CAPTURE(size);
      CHECK(total(settings(projection, 180.0, size, size)) == doctest::Approx(2.0 * kPi).epsilon(1e-11));
    }
    CHECK(total(settings(projection, 180.0, 300, 400)) == doctest::Approx(2.0 * kPi).epsilon(1e-11));
    CHECK(total(settings(projection, 90.0, 200, 200, 60.0)) ==
          doctest::Approx(2.0 * kPi * (1.0 - std::cos(kPi / 6.0))).epsilon(1e-11));
  }
  for (const Projection projection : {Projection::fisheyeEqualArea, Projection::fisheyeEquidistant}) {
    for (const int size : {1, 2, 3, 200}) {
      CHECK(total(settings(projection, 360.0, size, size, 360.0)) == doctest::Approx(4.0 * kPi).epsilon(1e-11));
    }
  }
  CHECK(total(settings(Projection::fisheyeStereographic, 350.0, 333, 333, 350.0)) ==
        doctest::Approx(2.0 * kPi * (1.0 + std::cos(radians(5.0)))).epsilon(1e-11));
}

TEST_CASE("the pixels of an equirectangular panorama add up to the sphere, whatever its shape") {
  CHECK(total(settings(Projection::equirectangular, 360.0, 400, 200)) == doctest::Approx(4.0 * kPi).epsilon(1e-12));
  // Rows beyond the poles show no sky.
  const CameraSettings square = settings(Projection::equirectangular, 360.0, 90, 90);
  CHECK(total(square) == doctest::Approx(4.0 * kPi).epsilon(1e-12));
  CHECK(Camera(square).solidAngle(3, 0) == 0.0);
  CHECK_FALSE(Camera(square).toSky({3.0, 1.0}).has_value());
  CHECK(total(settings(Projection::equirectangular, 90.0, 80, 40)) ==
        doctest::Approx(0.5 * kPi * 2.0 * std::sin(kPi / 8.0)).epsilon(1e-12));
}

TEST_CASE("the pixels of a rectilinear picture add up to the pyramid over its frame") {
  for (const double fov : {1.0, 60.0, 150.0, 179.0}) {
    CAPTURE(fov);
    const double a = std::tan(radians(0.5 * fov)), b = a * 2.0 / 3.0;
    const double pyramid = 4.0 * std::atan(a * b / std::sqrt(1.0 + a * a + b * b));
    CHECK(total(settings(Projection::rectilinear, fov, 300, 200)) ==
          doctest::Approx(pyramid).epsilon(1e-12).scale(0.0));
    CHECK(total(settings(Projection::rectilinear, fov, 3, 2)) == doctest::Approx(pyramid).epsilon(1e-12).scale(0.0));
  }
}

TEST_CASE("the solid angle of single pixels agrees with quadrature to 1e-10") {
  std::mt19937 random(3);
  const std::array cameras = {settings(Projection::rectilinear, 170.0, 1000, 700),
                              settings(Projection::fisheyeEqualArea, 180.0, 999, 999),
                              settings(Projection::fisheyeEquidistant, 360.0, 1001, 999, 360.0),
                              settings(Projection::fisheyeStereographic, 340.0, 1000, 1000),
                              settings(Projection::fisheyeOrthographic, 180.0, 1000, 1000),
                              settings(Projection::fisheyeOrthographic, 180.0, 8000, 8000),
                              settings(Projection::equirectangular, 360.0, 1001, 500),
                              settings(Projection::fisheyeEquidistant, 3.0, 8000, 8000),
                              settings(Projection::rectilinear, 0.5, 8000, 8000)};
  for (const CameraSettings& s : cameras) {
    CAPTURE(std::string(nameOf(s.projection)));
    const Camera camera(s);
    const double limit = s.projection == Projection::fisheyeOrthographic ? 0.99 : 1e9;  // 1 - r^2 is singular at 1
    const double circle = s.projection == Projection::fisheyeEquidistant ? kPi : limit * 1.0;
    for (int i = 0; i < 300; ++i) {
      const int x = i == 0 ? s.width / 2 : static_cast<int>(random() % static_cast<unsigned>(s.width));
      const int y = i == 0 ? s.height / 2 : static_cast<int>(random() % static_cast<unsigned>(s.height));
      const double dx = (std::abs(x + 0.5 - 0.5 * s.width) + 0.5) / camera.focalLength();
      const double dy = (std::abs(y + 0.5 - 0.5 * s.height) + 0.5) / camera.focalLength();
      double rim = std::min(limit, circle);
      if (s.projection == Projection::fisheyeEqualArea) rim = std::sqrt(2.0);
      if (s.projection == Projection::fisheyeStereographic) rim = 2.0 * std::tan(radians(85.0));
      if (s.projection != Projection::equirectangular && std::hypot(dx, dy) > rim) continue;
      CHECK(std::abs(camera.solidAngle(x, y) / quadrature(camera, x, y, 2) - 1.0) < 1e-10);
    }
  }
}

TEST_CASE("pixels cut by the image circle hold the part inside it") {
  // By polar quadrature of the part of the pixel inside the circle, row by row: the chord ends at sqrt(R^2 - y^2).
  for (const Projection projection :
       {Projection::fisheyeEqualArea, Projection::fisheyeEquidistant, Projection::fisheyeStereographic}) {
    CAPTURE(std::string(nameOf(projection)));
    const Camera camera(settings(projection, 180.0, 64, 64));
    int cut = 0;
    for (int y = 33; y < 50; ++y) {
      for (int x = 40; x < 64; ++x) {
        const double outer = std::hypot(x + 1 - 32.0, y + 1 - 32.0), inner = std::hypot(x - 32.0, y - 32.0);
        if (inner >= 32.0 || outer <= 32.0) continue;
        const auto row = [&](double v) {
          const double end = 32.0 + std::sqrt(std::max(0.0, 1024.0 - (v - 32.0) * (v - 32.0)));
          const double right = std::min(end, x + 1.0);
          return right > x ? gauss([&](double u) { return density(camera, u, v); }, x, right, 2) : 0.0;
        };
        // The row's integral has corners where the circle enters and leaves through the sides: split there.
        const auto crossing = [&](double u) {
          return 32.0 + std::sqrt(std::max(0.0, 1024.0 - (u - 32.0) * (u - 32.0)));
        };
        const double top = std::clamp(crossing(x + 1.0), y + 0.0, y + 1.0);
        const double bottom = std::clamp(crossing(x + 0.0), y + 0.0, y + 1.0);
        const double expected = gauss(row, y, top, 8) + gauss(row, top, bottom, 8);
        const double whole = density(camera, x + 0.5, y + 0.5);
        CHECK(std::abs(camera.solidAngle(x, y) - expected) < 1e-10 * whole);
        ++cut;
      }
    }
    CHECK(cut > 15);
  }
}

TEST_CASE("an isotropic sky stays flat up to the pixels at 90 degrees") {
  // Equal numbers of directions per solid angle; count / solid angle must be the same everywhere within 5 sigma.
  CameraSettings s = settings(Projection::fisheyeOrthographic, 180.0, 40, 40);
  const Camera camera(s);
  const std::vector<double> omega = camera.solidAngles();
  std::vector<double> counts(omega.size());
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const int samples = 2'000'000;
  for (int i = 0; i < samples; ++i) {
    const double z = unit(random), phi = 2.0 * kPi * unit(random), r = std::sqrt(1.0 - z * z);
    const auto pixel = camera.pixelAt({r * std::cos(phi), r * std::sin(phi), z});
    REQUIRE(pixel.has_value());
    counts[static_cast<std::size_t>(*pixel)] += 1.0;
  }
  double chi2 = 0.0;
  int cells = 0;
  for (std::size_t i = 0; i < omega.size(); ++i) {
    const double expected = samples * omega[i] / (2.0 * kPi);
    if (expected < 20.0) continue;
    ++cells;
    CHECK(std::abs(counts[i] - expected) < 5.0 * std::sqrt(expected));
    chi2 += (counts[i] - expected) * (counts[i] - expected) / expected;
  }
  CHECK(cells > 1200);
  CHECK(std::abs(chi2 - cells) < 5.0 * std::sqrt(2.0 * cells));
}

}  // namespace parhelion
