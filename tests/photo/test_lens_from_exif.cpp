// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "error_text.h"
#include "math/rotation.h"
#include "photo/lens_from_exif.h"
#include "sky/camera.h"

namespace parhelion {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr std::array kProjections = {Projection::rectilinear,         Projection::fisheyeEqualArea,
                                     Projection::fisheyeEquidistant,  Projection::fisheyeStereographic,
                                     Projection::fisheyeOrthographic, Projection::equirectangular};

// Rounding of a few operations, relative.
constexpr double kRounding = 1e-14;

Exif equivalent(double mm) {
  Exif exif;
  exif.focalLength35mm = mm;
  return exif;
}

/// 50 mm before a sensor of 100 pixels a millimetre: 5000 pixels.
Exif sensor() {
  Exif exif;
  exif.focalLength = 50.0;
  exif.focalPlaneX = exif.focalPlaneY = 1000.0;
  exif.focalPlaneUnit = 3;
  exif.pixelWidth = 3600;
  exif.pixelHeight = 2400;
  return exif;
}

double focalOf(const Exif& exif, int width, int height) {
  const auto facts = lensFromExif(exif, width, height);
  REQUIRE(facts.has_value());
  return facts->focalPixels;
}

/// What the refusal says; empty where there is none.
std::string refusal(const Exif& exif) {
  return errorOf<std::invalid_argument>([&] { lensFromExif(exif, 3600, 2400); });
}

}  // namespace

TEST_CASE("a 35 mm equivalent of 50 mm sees 39.6 degrees across a picture of 3 to 2") {
  const double focal = focalOf(equivalent(50.0), 6000, 4000);
  CHECK(2.0 * std::atan(3000.0 / focal) == doctest::Approx(2.0 * std::atan(18.0 / 50.0)).epsilon(kRounding));
  CHECK(focalOf(equivalent(50.0), 4000, 6000) == focal);
}

TEST_CASE("a 35 mm equivalent fixes the diagonal of a picture of 4 to 3") {
  const double focal = focalOf(equivalent(28.0), 4000, 3000);
  const double film = std::sqrt(36.0 * 36.0 + 24.0 * 24.0);
  CHECK(2500.0 / focal == doctest::Approx(0.5 * film / 28.0).epsilon(kRounding));
}

TEST_CASE("a focal length and the sensor's resolution give the focal length in pixels") {
  CHECK(focalOf(sensor(), 3600, 2400) == doctest::Approx(5000.0).epsilon(kRounding));
  Exif inches = sensor();
  inches.focalPlaneX = 2540.0;
  inches.focalPlaneUnit = 2;
  CHECK(focalOf(inches, 3600, 2400) == doctest::Approx(5000.0).epsilon(kRounding));
  Exif rows = sensor();
  rows.focalPlaneX.reset();
  CHECK(focalOf(rows, 3600, 2400) == doctest::Approx(5000.0).epsilon(kRounding));
}

TEST_CASE("a picture that was made smaller or turned since has its focal length scaled with it") {
  CHECK(focalOf(sensor(), 1800, 1200) == doctest::Approx(2500.0).epsilon(kRounding));
  CHECK(focalOf(sensor(), 2400, 3600) == doctest::Approx(5000.0).epsilon(kRounding));
  CHECK(focalOf(sensor(), 800, 1200) == doctest::Approx(5000.0 / 3.0).epsilon(kRounding));
  CHECK(focalOf(sensor(), 100, 67) == doctest::Approx(5000.0 / 36.0).epsilon(kRounding));
  Exif width = sensor();
  width.pixelHeight.reset();
  CHECK(focalOf(width, 1800, 1200) == doctest::Approx(2500.0).epsilon(kRounding));
  width.orientation = 6;
  CHECK(focalOf(width, 1200, 1800) == doctest::Approx(2500.0).epsilon(kRounding));
}

TEST_CASE("a picture that was cropped since has no focal length from Exif") {
  for (Exif exif : {sensor(), equivalent(50.0)}) {
    exif.pixelWidth = 3600;
    exif.pixelHeight = 2400;
    CHECK_NOTHROW(lensFromExif(exif, 2400, 3600));
    CHECK_THROWS_WITH_AS(lensFromExif(exif, 3600, 2000),
                         "Exif tells of 3600 x 2400 pixels, the picture has 3600 x 2000 pixels: it has been cropped, "
                         "and its field of view is not Exif's; if no more was cut off than its shape asks, it is 52.5 "
                         "mm on 35 mm film, 39.6 degrees from left to right unless a fisheye's",
                         std::invalid_argument);
    exif.sizesTaken = {{3600, 2000}};
    CHECK_NOTHROW(lensFromExif(exif, 3600, 2000));
    exif.sizesTaken = {{4000, 2000}};
    CHECK(contains(refusal(exif), "Exif tells of 4000 x 2000 pixels"));
  }
}

TEST_CASE("of two focal lengths in Exif that agree the finer is taken and else the 35 mm equivalent") {
  const double film = 5000.0 / std::hypot(3600.0, 2400.0) * std::hypot(36.0, 24.0);  // mm
  Exif exif = sensor();
  exif.focalLength35mm = 1.19 * film;
  CHECK(focalOf(exif, 3600, 2400) == doctest::Approx(5000.0).epsilon(kRounding));
  exif.focalLength35mm = 1.21 * film;
  CHECK(focalOf(exif, 3600, 2400) == doctest::Approx(1.21 * 5000.0).epsilon(kRounding));
  CHECK(contains(lensFromExif(exif, 3600, 2400)->source, "says 0.826446 times that"));
  exif.focalLength35mm = film / 1.21;
  CHECK(focalOf(exif, 3600, 2400) == doctest::Approx(5000.0 / 1.21).epsilon(kRounding));
  // A resolution that cannot be does no harm beside an equivalent.
  exif.focalPlaneX = kInfinity;
  CHECK(focalOf(exif, 3600, 2400) == doctest::Approx(5000.0 / 1.21).epsilon(kRounding));
}

TEST_CASE("Exif without a focal length or without its scale says nothing of the lens") {
  CHECK_FALSE(lensFromExif(Exif{}, 3600, 2400).has_value());
  Exif exif = sensor();
  exif.focalPlaneUnit = 1;
  CHECK_FALSE(lensFromExif(exif, 3600, 2400).has_value());
  exif = sensor();
  exif.focalPlaneX.reset();
  exif.focalPlaneY.reset();
  CHECK_FALSE(lensFromExif(exif, 3600, 2400).has_value());
  exif = sensor();
  exif.focalLength.reset();
  CHECK_FALSE(lensFromExif(exif, 3600, 2400).has_value());
}

TEST_CASE("a focal length or equivalent of 0 is unknown, and the other is taken") {
  CHECK_FALSE(lensFromExif(equivalent(0.0), 3600, 2400).has_value());
  Exif exif = equivalent(50.0);
  exif.focalLength = 0.0;
  CHECK(focalOf(exif, 3600, 2400) == focalOf(equivalent(50.0), 3600, 2400));
  Exif phone = equivalent(0.0);
  phone.focalLength = 4.25;
  phone.focalPlaneX = phone.focalPlaneY = 714.2;
  phone.focalPlaneUnit = 3;
  CHECK(focalOf(phone, 400, 300) == doctest::Approx(4.25 * 71.42).epsilon(kRounding));
  CHECK(lensFromExif(phone, 400, 300)->source == "focal length 4.25 mm at 71.42 pixels/mm");
}

TEST_CASE("Exif that lies is refused with its value") {
  const std::array<std::pair<double, const char*>, 4> lies = {
      {{-50.0, " -50 mm"}, {kInfinity, " inf mm"}, {4294967246.0, " 4.29497e+09 mm"}, {0.4, " 0.4 mm"}}};
  for (const auto& [value, words] : lies) {
    CHECK(contains(refusal(equivalent(value)), words));
    Exif exif = sensor();
    exif.focalLength = value;
    CHECK(contains(refusal(exif), words));
    exif.focalLength35mm = 50.0;
    CHECK(contains(refusal(exif), words));
  }
  for (const double resolution : {0.0, -1000.0, kInfinity}) {
    Exif exif = sensor();
    exif.focalPlaneX = resolution;
    CHECK(focalOf(exif, 3600, 2400) == doctest::Approx(5000.0).epsilon(kRounding));
    exif.focalPlaneY = resolution;
    CHECK_FALSE(lensFromExif(exif, 3600, 2400).has_value());
  }
}

TEST_CASE("the sensor's resolution may be told for an inch, a centimetre, a millimetre or a micrometre") {
  for (const auto& [unit, length] : {std::pair{2, 25.4}, {3, 10.0}, {4, 1.0}, {5, 1e-3}}) {
    Exif exif = sensor();
    exif.focalPlaneX = 100.0 * length;
    exif.focalPlaneUnit = unit;
    CHECK(focalOf(exif, 3600, 2400) == doctest::Approx(5000.0).epsilon(kRounding));
  }
}

TEST_CASE(
    "a resolution of the picture before it was scaled is used with the size it had then, and never with another") {
  // 50 mm before a sensor of 5472 x 3648 pixels on 22.3 mm: 25.2 degrees.
  Exif exif;
  exif.focalLength = 50.0;
  exif.focalPlaneX = exif.focalPlaneY = 2452.118652;
  exif.focalPlaneUnit = 3;
  const double whole = 2.0 * std::atan(0.5 * 5472.0 / (50.0 * 245.2118652));
  const auto across = [](const Exif& told, int width, int height) {
    return 2.0 * std::atan(0.5 * width / focalOf(told, width, height));
  };
  CHECK(degrees(whole) == doctest::Approx(25.2).epsilon(0.01));
  CHECK(across(exif, 5472, 3648) == doctest::Approx(whole).epsilon(1e-12));

  for (const auto& [width, height] : {std::pair{2560, 1707}, std::pair{1280, 853}, std::pair{300, 200}}) {
    CAPTURE(width);
    CHECK_THROWS_AS(lensFromExif(exif, width, height), std::invalid_argument);

    Exif withSize = exif;
    withSize.pixelWidth = 5472;
    CHECK(across(withSize, width, height) == doctest::Approx(whole).epsilon(1e-12));
    withSize.pixelHeight = 3648;
    CHECK(across(withSize, width, height) == doctest::Approx(whole).epsilon(1e-12));

    // A program that writes Exif's size anew leaves the maker's note.
    Exif withNote = exif;
    withNote.pixelWidth = width;
    withNote.pixelHeight = height;
    CHECK_THROWS_AS(lensFromExif(withNote, width, height), std::invalid_argument);
    withNote.sizesTaken = {{5472, 3648}};
    CHECK(across(withNote, width, height) == doctest::Approx(whole).epsilon(1e-12));

    Exif withModel = exif;
    withModel.make = "Canon";
    withModel.model = "Canon EOS 70D";
    CHECK(across(withModel, width, height) == doctest::Approx(whole).epsilon(0.01));
    CHECK(contains(lensFromExif(withModel, width, height)->source, "Canon EOS 70D"));
    CHECK_THROWS_AS(lensFromExif(withModel, width, width * 10 / 16), std::invalid_argument);
  }
}

TEST_CASE("a picture's implied sensor that no camera has is told, and so is one that may be a larger one's") {
  Exif exif;
  exif.focalLength = 50.0;
  exif.focalPlaneX = 2452.118652;
  exif.focalPlaneUnit = 3;
  const auto refusalFor = [&](int width, int height) {
    return errorOf<std::invalid_argument>([&] { lensFromExif(exif, width, height); });
  };
  CHECK(
      refusalFor(2560, 1707) ==
      "Exif has a focal length of 50 mm at 245.212 pixels/mm, and so the picture a sensor of 10.4 mm, which no common "
      "camera has: it was made smaller or larger since, or cropped");
  CHECK(
      contains(refusalFor(1280, 853), "a sensor of 5.22 mm, but it may be of a larger sensor and made smaller since"));
  for (const int width : {5000, 3000, 2400, 1000})
    CHECK(contains(refusalFor(width, width / 3 * 2), "no common camera"));
  // So fine a resolution is that of a small sensor, and so short a lens has no larger one.
  exif.focalPlaneX = 6483.0;
  CHECK(refusalFor(4000, 3000).empty());
  exif.focalPlaneX = 2452.118652;
  exif.focalLength = 5.0;
  CHECK(refusalFor(1280, 960).empty());
}

TEST_CASE("a size in Exif that the resolution belies is passed over") {
  Exif exif = sensor();
  exif.pixelWidth = 180;
  exif.pixelHeight = 120;
  CHECK(focalOf(exif, 3600, 2400) == doctest::Approx(5000.0).epsilon(kRounding));
  exif.pixelWidth = 65535;
  exif.pixelHeight = 43690;
  CHECK(focalOf(exif, 3600, 2400) == doctest::Approx(5000.0).epsilon(kRounding));
  exif.pixelWidth = 0;
  exif.pixelHeight = -1;
  CHECK(focalOf(exif, 3600, 2400) == doctest::Approx(5000.0).epsilon(kRounding));
}

TEST_CASE("a known model needs no resolution, of any shape that the camera may have chosen with one") {
  Exif exif;
  exif.make = "OLYMPUS IMAGING CORP.";
  exif.model = "E-M1";
  exif.focalLength = 7.0;
  CHECK(focalOf(exif, 2000, 1500) == doctest::Approx(7.0 / 17.3 * 2000.0).epsilon(kRounding));
  CHECK(focalOf(exif, 1500, 2000) == doctest::Approx(7.0 / 17.3 * 2000.0).epsilon(kRounding));
  CHECK_THROWS_AS(lensFromExif(exif, 2560, 1600), std::invalid_argument);

  exif.focalPlaneX = 2663.6;  // 4608 pixels on 17.3 mm
  exif.focalPlaneUnit = 3;
  for (const auto& [width, height] : {std::pair{4608, 3456}, {4608, 2592}, {3456, 3456}, {2592, 4608}})
    CHECK(focalOf(exif, width, height) == doctest::Approx(7.0 * 266.36).epsilon(kRounding));
}

TEST_CASE("a digital zoom counts, and is asked about where the equivalent may hold it") {
  Exif exif = sensor();
  for (const double none : {0.0, 1.0, 1.02, -2.0, kInfinity, 1e6}) {
    exif.digitalZoom = none;
    CHECK(focalOf(exif, 3600, 2400) == doctest::Approx(5000.0).epsilon(kRounding));
  }
  exif.digitalZoom = 2.0;
  CHECK(focalOf(exif, 3600, 2400) == doctest::Approx(10000.0).epsilon(kRounding));
  CHECK(contains(lensFromExif(exif, 3600, 2400)->source, "digital zoom 2"));
  exif.focalLength35mm = 50.0;
  CHECK(focalOf(exif, 3600, 2400) == doctest::Approx(10000.0).epsilon(kRounding));
  Exif film = equivalent(28.0);
  film.digitalZoom = 2.0;
  CHECK(refusal(film) ==
        "Exif has a digital zoom of 2 and a 35 mm equivalent of 28 mm, which may count it or not: it is 28 or 56");
}

TEST_CASE("the field of view set for a focal length has that focal length in every projection") {
  for (const Projection projection : kProjections) {
    CAPTURE(std::string(nameOf(projection)));
    for (const auto& [width, height] : {std::pair{6000, 4000}, std::pair{3000, 4000}, std::pair{512, 512}}) {
      const double span = std::hypot(width, height);
      for (const double diagonals : {0.2, 0.35, 0.6, 1.0, 7.0, 400.0}) {
        CAPTURE(diagonals);
        CameraSettings settings;
        settings.projection = projection;
        settings.width = width;
        settings.height = height;
        const double shorter = 0.5 * std::min(width, height) / span / diagonals;
        if (projection == Projection::fisheyeOrthographic && shorter > 1.0) {
          CHECK_THROWS_AS(withFocalLength(settings, diagonals * span), std::invalid_argument);
        } else {
          const double focal = Camera(withFocalLength(settings, diagonals * span)).focalLength();
          CHECK(focal == doctest::Approx(diagonals * span).epsilon(1e-12));
        }
      }
    }
  }
}

TEST_CASE("a field of view is taken along the longest extent that the projection can show") {
  CameraSettings settings;
  settings.projection = Projection::fisheyeOrthographic;
  settings.width = 600;
  settings.height = 400;
  CHECK(withFocalLength(settings, 400.0).fieldOfViewAxis == FieldOfViewAxis::diagonal);
  CHECK(withFocalLength(settings, 310.0).fieldOfViewAxis == FieldOfViewAxis::horizontal);
  CHECK(withFocalLength(settings, 300.0).fieldOfView == doctest::Approx(kPi).epsilon(kRounding));
  CHECK(withFocalLength(settings, 250.0).fieldOfViewAxis == FieldOfViewAxis::vertical);
  CHECK_THROWS_WITH_AS(withFocalLength(settings, 199.0),
                       "a fisheye-orthographic lens with a focal length of 199 pixels does not fill the picture along "
                       "either side",
                       std::invalid_argument);
  std::swap(settings.width, settings.height);
  CHECK(withFocalLength(settings, 310.0).fieldOfViewAxis == FieldOfViewAxis::vertical);
  for (const double focal : {0.0, -1.0, kInfinity, std::nan("")})
    CHECK_THROWS_AS(withFocalLength(settings, focal), std::invalid_argument);
}

}  // namespace parhelion
