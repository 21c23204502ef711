// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "picture/colour_space.h"
#include "picture/tone.h"
#include "picture/transfer.h"

namespace parhelion {
namespace {

Image rgbImage(int width, int height, const Vec3& rgb) {
  Image image{width, height, {}};
  for (int c = 0; c < 3; ++c) {
    auto& plane = image.add(std::array{"R", "G", "B"}[static_cast<std::size_t>(c)]);
    std::fill(plane.begin(), plane.end(), static_cast<float>(rgb[c]));
  }
  return image;
}

}  // namespace

TEST_CASE("the sun's white comes out as exactly R = G = B = 1, whatever it is") {
  for (const Vec3& white : {Vec3{0.95, 1.0, 1.09}, Vec3{1.0, 1.0, 1.0}, Vec3{1.1, 1.0, 0.35}, Vec3{0.9, 1.0, 1.6}}) {
    const Vec3 rgb = xyzToRec709(white) * white;
    for (int c = 0; c < 3; ++c) CHECK(rgb[c] == doctest::Approx(1.0).epsilon(1e-15));
  }
}

TEST_CASE("without adaptation XYZ to Rec.709 is the matrix of IEC 61966-2-1") {
  const Vec3 d65{0.3127 / 0.3290, 1.0, (1.0 - 0.3127 - 0.3290) / 0.3290};
  const Mat3 m = xyzToRec709(d65);  // columns
  CHECK(m[0][0] == doctest::Approx(3.2406).epsilon(2e-4));
  CHECK(m[1][0] == doctest::Approx(-1.5372).epsilon(2e-4));
  CHECK(m[0][1] == doctest::Approx(-0.9689).epsilon(2e-4));
  CHECK(m[2][2] == doctest::Approx(1.0570).epsilon(2e-4));
  const Mat3 back = glm::inverse(m);
  for (int c = 0; c < 3; ++c) CHECK(back[c][1] == doctest::Approx(kRec709Luminance[c]).epsilon(1e-9));
}

TEST_CASE("Bradford adaptation from illuminant A to D65 agrees with the published matrix") {
  // Lindbloom, "Chromatic Adaptation": the Bradford matrix A -> D65, row by row.
  const std::array<Vec3, 3> rows = {Vec3{0.8446965, -0.1179225, 0.3948108}, Vec3{-0.1366303, 1.1041226, 0.1291718},
                                    Vec3{0.0798489, -0.1348999, 3.1924009}};
  const Vec3 d65{0.95047, 1.0, 1.08883}, a{1.09850, 1.0, 0.35585};
  const Mat3 adaptation = glm::inverse(xyzToRec709(d65)) * xyzToRec709(a);
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      CHECK(std::abs(adaptation[c][r] - rows[static_cast<std::size_t>(r)][c]) < 5e-4);  // its D65 has fewer digits
    }
  }
}

TEST_CASE("a white that no eye adapts to gives finite colours") {
  const Vec3 red{2.65, 1.0, 0.0};  // a line at 650 nm
  const Vec3 rgb = xyzToRec709(red) * red;
  CHECK(std::isfinite(rgb.x + rgb.y + rgb.z));
  CHECK(rgb.x > 1.0);
}

TEST_CASE("the tone curve rises with the light, for greys and for colours, from black to white") {
  for (const Vec3& colour : {Vec3{1, 1, 1}, Vec3{1, 0.5, 0.1}, Vec3{0.0, 0.2, 1.0}}) {
    Vec3 before(0.0);
    for (double stops = -40.0; stops < 60.0; stops += 0.125) {
      const Vec3 now = toneCurve(std::exp2(stops) * colour);
      for (int c = 0; c < 3; ++c) {
        CHECK(now[c] >= before[c]);
        CHECK(now[c] <= 1.0);
      }
      before = now;
    }
    CHECK(std::min({before.x, before.y, before.z}) > 0.999);
  }
  CHECK(toneCurve(Vec3(1e-9)).x == doctest::Approx(1e-9).epsilon(2e-9).scale(0.0));
  CHECK(toneCurve(Vec3(0.0)) == Vec3(0.0));
}

TEST_CASE("hue stays the same at any brightness, white stays neutral") {
  const auto hue = [](const Vec3& c) {
    const double lo = std::min({c.x, c.y, c.z}), hi = std::max({c.x, c.y, c.z});
    return (c - Vec3(lo)) / (hi - lo);
  };
  std::mt19937 random(9);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    const Vec3 colour{unit(random), unit(random), unit(random)};
    const double light = std::exp2(12.0 * unit(random) - 6.0);
    CHECK(glm::length(hue(toneCurve(light * colour)) - hue(colour)) < 1e-9);
    const Vec3 grey = toneCurve(Vec3(light));
    CHECK(grey.x == grey.y);
    CHECK(grey.y == grey.z);
  }
}

TEST_CASE("colours out of gamut come in at the same luminance, with one component just 0") {
  const Vec3 display = toneCurve(1e-6 * Vec3{-0.2, 0.8, 0.3});
  CHECK(std::abs(display.x) < 1e-20);
  CHECK(display.y > display.z);
  const double luminance = glm::dot(kRec709Luminance, Vec3{-0.2, 0.8, 0.3});
  CHECK(glm::dot(kRec709Luminance, display) == doctest::Approx(1e-6 * luminance).epsilon(1e-6).scale(0.0));
  CHECK(toneCurve({-1.0, -1.0, -1.0}) == Vec3(0.0));
  CHECK(toneCurve({0.0, 0.0, -1.0}) == Vec3(0.0));
}

TEST_CASE("no light, however odd, makes the tone curve leave [0, 1]") {
  const double inf = std::numeric_limits<double>::infinity(), huge = 1e308, tiny = 5e-324;
  for (const double r : {0.0, tiny, huge, -huge, inf, std::nan("")}) {
    for (const double g : {0.0, 1.0, tiny, huge, -huge}) {
      for (const double b : {0.0, 1.0, huge, -1e-300}) {
        const Vec3 c = toneCurve({r, g, b});
        for (int k = 0; k < 3; ++k) CHECK((c[k] >= 0.0 && c[k] <= 1.0));
      }
    }
  }
}

TEST_CASE("every tone curve rises from black to white and keeps the hue, in and beyond its middle") {
  const Vec3 colour{0.2, 1.0, 0.4};
  for (const ToneCurve curve : {ToneCurve::reinhard, ToneCurve::filmic, ToneCurve::linear}) {
    CAPTURE(nameOf(curve));
    double before = 0.0;
    for (double stops = -40.0; stops < 60.0; stops += 0.125) {
      const Vec3 now = toneCurve(std::exp2(stops) * colour, curve);
      CHECK(now.y >= before);
      CHECK(now.y <= 1.0);
      before = now.y;
      // (middle - least) / (greatest - least) is the hue; a white that is faded to has none any more.
      if (stops < 12.0) CHECK((now.z - now.x) / (now.y - now.x) == doctest::Approx(0.25).epsilon(1e-6));
    }
    CHECK(before > 0.999);
    CHECK(toneCurve(Vec3(0.0), curve) == Vec3(0.0));
    CHECK(toneCurve(Vec3(std::nan("")), curve) == Vec3(0.0));
    CHECK(toneCurve(Vec3(1e308), curve).x <= 1.0);
  }
}

TEST_CASE("the curves have the values of their definitions") {
  CHECK(toneCurve(Vec3(3.0), ToneCurve::reinhard).x == doctest::Approx(0.75));
  CHECK(toneCurve(Vec3(0.3), ToneCurve::linear).x == 0.3);
  CHECK(toneCurve(Vec3(30.0), ToneCurve::linear) == Vec3(1.0));
  // What is over-exposed fades to white, as it does on film and on a sensor: a sun is not darker than its sky.
  CHECK(toneCurve(Vec3(1.0, 0.5, 0.0), ToneCurve::linear) == Vec3(1.0, 0.5, 0.0));
  CHECK(toneCurve(Vec3(9.0, 4.5, 0.0), ToneCurve::linear).y == doctest::Approx(0.75));
  CHECK(toneCurve(Vec3(1e4, 5e3, 0.0), ToneCurve::linear).z > 0.99);
  // Narkowicz 2015 at 1: 2.54 / 3.16.
  CHECK(toneCurve(Vec3(1.0), ToneCurve::filmic).x == doctest::Approx(0.803797).epsilon(1e-4));
  CHECK(toneCurve(Vec3(7.0), ToneCurve::filmic).x < 1.0);
  CHECK(toneCurve(Vec3(7.4), ToneCurve::filmic).x == 1.0);
}

TEST_CASE("at an exposure value, 0.125 cd/m2 times its power of two is mid-grey, whatever the unit and the curve") {
  for (const ToneCurve curve : {ToneCurve::reinhard, ToneCurve::filmic, ToneCurve::linear}) {
    CAPTURE(nameOf(curve));
    CHECK(toneCurve(Vec3(midGreyOf(curve)), curve).x == doctest::Approx(0.18).epsilon(1e-5));
    for (const double ev : {-3.0, 0.0, 13.0}) {
      for (const double white : {1.0, 250.0, 1e-3}) {
        const double luminance = 0.125 * std::exp2(ev);
        const double exposed = std::exp2(exposureFor(ev, white, curve)) * luminance / white;
        CHECK(toneCurve(Vec3(exposed), curve).x == doctest::Approx(0.18).epsilon(1e-5));
      }
    }
  }
}

TEST_CASE("sRGB encoding has its known values") {
  CHECK(srgbEncode(0.0) == 0.0);
  CHECK(srgbEncode(1.0) == doctest::Approx(1.0).epsilon(1e-14));
  CHECK(srgbEncode(0.0031308) == doctest::Approx(0.04045).epsilon(1e-5));
  CHECK(srgbEncode(0.2140411) == doctest::Approx(0.5).epsilon(1e-6));
}

TEST_CASE("bright parts stay apart and keep their hue") {
  const auto code = [](double light) { return 255.0 * srgbEncode(toneCurve(Vec3(light)).x); };
  CHECK(code(13.0) - code(1.1) > 40.0);
  CHECK(code(100.0) - code(13.0) > 5.0);
  const Vec3 orange = toneCurve(13.0 * Vec3(1.0, 0.5, 0.1));
  CHECK(std::abs(orange.y / orange.x - 0.5) < 0.01);
  CHECK(std::abs(orange.z / orange.x - 0.1) < 0.01);
}

TEST_CASE("a black image develops to black") {
  const Image black = rgbImage(16, 16, Vec3(0.0));
  const Preview preview = developPreview(black, {});
  CHECK(std::all_of(preview.rgb.begin(), preview.rgb.end(), [](std::uint8_t v) { return v == 0; }));
  CHECK(preview.badPixels == 0);
}

TEST_CASE("pixels that are not finite are black and counted") {
  Image image = rgbImage(4, 4, Vec3(1.0));
  image.channels[1].samples[3] = std::nanf("");
  image.channels[2].samples[5] = std::numeric_limits<float>::infinity();
  const Preview preview = developPreview(image, {});
  CHECK(preview.badPixels == 2);
  CHECK(preview.rgb[9] == 0);
  CHECK(preview.rgb[15] == 0);
  CHECK(preview.rgb[0] > 180);
}

TEST_CASE("the dither of a flat grey stays within a step and keeps its mean") {
  const double linear = 0.003;
  const Preview preview = developPreview(rgbImage(64, 64, Vec3(linear)), {});
  double sum = 0.0;
  int lo = 255, hi = 0;
  for (const std::uint8_t v : preview.rgb) {
    sum += v;
    lo = std::min<int>(lo, v);
    hi = std::max<int>(hi, v);
  }
  CHECK(hi - lo <= 1);
  const double exact = 255.0 * srgbEncode(linear / (1.0 + linear));
  CHECK(std::abs(sum / static_cast<double>(preview.rgb.size()) - exact) < 1.0 / 64.0);
}

TEST_CASE("an image without R, G and B has no preview") {
  Image image{2, 2, {}};
  image.add("Y");
  CHECK_THROWS_AS(developPreview(image, {}), std::invalid_argument);
}

}  // namespace parhelion
