// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "error_text.h"
#include "pointing_cameras.h"

namespace parhelion {
namespace {

/// What a refused call says; empty if it is not refused.
std::string refusal(const CameraSettings& lens, const std::vector<PointingClue>& clues,
                    std::optional<double> roll = std::nullopt) {
  return errorOf<std::invalid_argument>([&] { findPointing(lens, clues, roll); });
}

}  // namespace

TEST_CASE("clues off by a pixel leave residuals of their number less the angles found") {
  // Squared residuals over sigma^2 = 1 pixel^2 are chi-squared: with f degrees of freedom the mean of n trials is f
  // within sqrt(2 f / n), here at 5 sigma. The long lens keeps a pixel the same angle everywhere within 1 %.
  CameraSettings truth = landscape();
  truth.fieldOfView = radians(12.0);
  truth.azimuth = 0.02;
  truth.elevation = 0.03;
  truth.roll = 0.2;
  const Camera camera(truth);
  constexpr int kTrials = 300;
  struct Setup {
    Tells others;
    bool rollGiven;
    double freedom;
  };
  for (const Setup& setup : {Setup{Tells::direction, false, 9.0}, Setup{Tells::direction, true, 10.0},
                             Setup{Tells::elevation, false, 4.0}, Setup{Tells::elevation, true, 5.0}}) {
    Draw draw(7);
    double sum = 0.0, sumAngles = 0.0;
    for (int trial = 0; trial < kTrials; ++trial) {
      std::vector<PointingClue> clues;
      for (const Vec2& place :
           {Vec2(100, 200), Vec2(400, 900), Vec2(800, 500), Vec2(1000, 100), Vec2(1400, 800), Vec2(1300, 400)}) {
        const Tells tells = clues.empty() ? Tells::direction : setup.others;
        clues.push_back(clueOf(camera, camera.directionAt(place).value(), tells));
        clues.back().pixel += Vec2(draw.gaussian(1.0), draw.gaussian(1.0));
      }
      const auto roll = setup.rollGiven ? std::optional(truth.roll) : std::nullopt;
      const Pointing found = findPointing(truth, clues, roll);
      sum += found.rmsPixels() * found.rmsPixels() * static_cast<double>(clues.size());
      sumAngles += found.rmsAngle() * found.rmsAngle() * static_cast<double>(clues.size());
    }
    const double allowed = 5.0 * std::sqrt(2.0 * setup.freedom / kTrials) + 0.01 * setup.freedom;
    CHECK(std::abs(sum / kTrials - setup.freedom) < allowed);
    const double pixelsPerRadian = camera.focalLength() * camera.focalLength();
    CHECK(std::abs(sumAngles / kTrials * pixelsPerRadian - setup.freedom) < allowed);
  }
}

TEST_CASE("no other camera has a smaller sum of squared angles than the one found") {
  Draw draw(8);
  for (const LensKind& kind : kLenses) {
    const CameraSettings truth = draw.turned(lensOf(kind));
    const Camera camera(truth);
    std::vector<PointingClue> clues;
    for (const Vec2& place : {Vec2(300, 350), Vec2(1200, 250), Vec2(1100, 800), Vec2(500, 700)}) {
      clues.push_back(clueOf(camera, camera.directionAt(place).value(), Tells::direction));
      clues.back().pixel += Vec2(draw.gaussian(3.0), draw.gaussian(3.0));
    }
    const auto squares = [&](double azimuth, double elevation, double roll) {
      CameraSettings s = truth;
      s.azimuth = azimuth;
      s.elevation = elevation;
      s.roll = roll;
      const Camera trial(s);
      double sum = 0.0;
      for (const PointingClue& clue : clues) {
        const double angle =
            angleBetween(trial.directionAt(clue.pixel).value(), skyDirection(*clue.azimuth, *clue.elevation));
        sum += angle * angle;
      }
      return sum;
    };
    const Pointing found = findPointing(truth, clues);
    const double least = squares(found.azimuth, found.elevation, found.roll);
    CHECK(least == doctest::Approx(4.0 * found.rmsAngle() * found.rmsAngle()).epsilon(1e-9));
    // Steps of 1e-6 rad, a thousandth of the clues' error: a slope left over would show in one of them.
    for (int k = 0; k < 27; ++k) {
      const auto step = [&](int place) { return 1e-6 * (k / place % 3 - 1); };
      CHECK(squares(found.azimuth + step(1), found.elevation + step(3), found.roll + step(9)) >= least);
    }
  }
}

TEST_CASE("a sun that cannot be there with that roll is refused with the elevations it could have") {
  // At the right border of an upright camera, 30 degrees off its axis, nothing is higher than 60 degrees.
  const PointingClue high{{1500.0, 500.0}, 0.0, radians(70.0)};
  CHECK(refusal(landscape(), {high}, 0.0) ==
        "pointing: with this roll, what is at the place of clue 1 has an elevation from -60.00 to 60.00 degrees, not "
        "70.00");
  const PointingClue possible{{1500.0, 500.0}, 0.0, radians(59.0)};
  CHECK(findPointing(landscape(), std::vector{possible}, 0.0).elevation ==
        doctest::Approx(std::asin(std::sin(radians(59.0)) / std::cos(radians(30.0)))));
}

TEST_CASE("a camera at the zenith with a given roll is found although its sun is a few pixels off") {
  // Whichever way it is off: half of them would need an elevation beyond 90 degrees.
  CameraSettings truth = lensOf(kLenses[3]);
  truth.azimuth = 0.3;
  truth.elevation = 0.5 * kPi;
  truth.roll = 0.2;
  PointingClue sun = clueOf(Camera(truth), skyDirection(0.0, 0.6), Tells::direction);
  const Vec2 place = sun.pixel;
  for (const Vec2& off : {Vec2(3, 0), Vec2(-3, 0), Vec2(0, 3), Vec2(0, -3), Vec2(2, 2), Vec2(-2, -2)}) {
    sun.pixel = place + off;
    const Pointing found = findPointing(truth, std::vector{sun}, truth.roll);
    CHECK(found.rmsPixels() < 3.001);
    CHECK(largestDifference(truth, turnedAs(truth, found)) < 0.02);
  }
}

TEST_CASE("clues that are not enough are refused with what is missing") {
  const PointingClue sun{{700.0, 300.0}, 0.0, 0.4};
  const PointingClue horizon{{200.0, 800.0}, std::nullopt, 0.0}, horizon2{{1200.0, 820.0}, std::nullopt, 0.0};
  const PointingClue sunAzimuth{{700.0, 300.0}, 0.0, std::nullopt};
  CHECK(contains(refusal(landscape(), {}), "no clue has an azimuth"));
  CHECK(contains(refusal(landscape(), {horizon, horizon2}, 0.0), "no clue has an azimuth"));
  CHECK(refusal(landscape(), {sun}) ==
        "pointing: the clues tell 2 of the 3 angles of a camera; the roll, another direction or points of the horizon "
        "must be added");
  CHECK(contains(refusal(landscape(), {sunAzimuth, horizon}), "2 of the 3 angles"));
  CHECK(contains(refusal(landscape(), {sunAzimuth}, 0.0), "an elevation must be added"));
  CHECK(refusal(landscape(), {sun, horizon}).empty());
  CHECK(refusal(landscape(), {sunAzimuth, horizon}, 0.0).empty());
}

TEST_CASE("clues that coincide or leave the camera free to turn are refused") {
  const PointingClue sun{{700.0, 300.0}, 0.0, 0.4};
  CHECK(contains(refusal(landscape(), {sun, sun}), "clue 1 and clue 2 are at the same place"));
  const PointingClue elsewhere{{900.0, 300.0}, 0.0, 0.4};
  CHECK(contains(refusal(landscape(), {sun, elsewhere}), "clue 1 and clue 2 are the same direction"));
  const PointingClue beside{{701.0, 300.0}, 0.001, 0.4};
  CHECK(contains(refusal(landscape(), {sun, beside}), "free to turn"));
  const PointingClue zenith{{750.0, 300.0}, 0.0, 0.5 * kPi};
  CHECK(contains(refusal(landscape(), {zenith}, 0.0), "free to turn"));
  // The sun on the horizon is one place that tells two things.
  const PointingClue azimuth{{700.0, 600.0}, 0.0, std::nullopt}, level{{700.0, 600.0}, std::nullopt, 0.0};
  CHECK(refusal(landscape(), {azimuth, level}, 0.1).empty());

  // Points of the horizon opposite each other leave the camera free to turn about their line.
  CameraSettings fisheye = lensOf({Projection::fisheyeEquidistant, radians(120.0), 0.0});
  const Camera camera(fisheye);
  const std::vector opposite = {clueOf(camera, skyDirection(0.5, 0.0), Tells::elevation),
                                clueOf(camera, skyDirection(0.5 + kPi, 0.0), Tells::elevation),
                                clueOf(camera, skyDirection(0.0, 0.3), Tells::azimuth)};
  CHECK(contains(refusal(fisheye, opposite), "free to turn"));
}

TEST_CASE("clues that contradict each other are refused with the angle by which they do") {
  const double focal = Camera(landscape()).focalLength();
  const double apart = 2.0 * std::atan(300.0 / focal);  // rad, of the two places
  const auto pair = [&](double azimuth) {
    return std::vector<PointingClue>{{{450.0, 500.0}, 0.0, 0.0}, {{1050.0, 500.0}, azimuth, 0.0}};
  };
  CHECK(contains(refusal(landscape(), pair(apart + radians(11.0))), "contradict each other: with the best camera"));
  CHECK(contains(refusal(landscape(), pair(apart + radians(11.0))), "is 5.50 degrees off"));
  const Pointing strained = findPointing(landscape(), pair(apart + radians(9.0)));
  for (const PointingResidual& residual : strained.residuals)
    CHECK(residual.angle == doctest::Approx(radians(4.5)).epsilon(1e-9));
}

TEST_CASE("clues of impossible numbers are refused") {
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(
      contains(refusal(landscape(), {{{700.0, 300.0}, std::nullopt, std::nullopt}}), "neither azimuth nor elevation"));
  CHECK(contains(refusal(landscape(), {{{infinity, 300.0}, 0.0, 0.4}}, 0.0), "finite"));
  CHECK(contains(refusal(landscape(), {{{700.0, 300.0}, infinity, 0.4}}, 0.0), "finite"));
  CHECK(contains(refusal(landscape(), {{{700.0, 300.0}, 0.0, 2.0}}, 0.0), "beyond 90 degrees"));
  CHECK(contains(refusal(landscape(), {{{700.0, 300.0}, 0.0, std::nan("")}}, 0.0), "beyond 90 degrees"));
  CHECK(contains(refusal(landscape(), {{{700.0, 300.0}, 0.0, 0.4}}, infinity), "roll"));
  CameraSettings fisheye;
  CHECK(contains(refusal(fisheye, {{{1e6, 300.0}, 0.0, 0.4}}, 0.0), "shows no sky"));
}

}  // namespace parhelion
