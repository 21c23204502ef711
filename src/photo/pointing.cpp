// SPDX-License-Identifier: Apache-2.0
#include "photo/pointing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "math/rotation.h"
#include "photo/pointing_fit.h"
#include "photo/pointing_starts.h"
#include "photo/sighting.h"
#include "sky/camera.h"

namespace parhelion {
namespace {

// Pixels. Places this close together are one place, told twice.
constexpr double kSamePlace = 0.01;

// rad. A fifth of an arc second: nobody tells two such directions apart in a photograph.
constexpr double kSameSighting = 1e-6;

// rad of the camera per rad on the sky. A pixel is of the order of 1 mrad; beyond this a clue that is off by one says
// nothing of where the camera pointed.
constexpr double kMostErrorGain = 1000.0;

// rad. Clues further off than this are not placed inexactly but wrongly.
constexpr double kContradiction = radians(5.0);

// rad. With a given roll, a camera at the zenith sees its sun at the very border of what is possible: a place a little
// off must not refuse it. More than the error of a careful place, less than any error to be told of.
constexpr double kBorderSlack = radians(1.0);

// Pixels. Half the distance over which the slope of elevation or azimuth across the picture is taken.
constexpr double kSlopeReach = 0.5;

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument("pointing: " + why); }

std::string inDegrees(double angle) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.2f", degrees(angle));
  return digits;
}

std::string clueName(std::size_t index) { return "clue " + std::to_string(index + 1); }

Camera unturned(CameraSettings lens) {
  lens.azimuth = lens.elevation = lens.roll = 0.0;
  return Camera(lens);
}

void validate(std::span<const PointingClue> clues, std::optional<double> roll) {
  if (roll && !std::isfinite(*roll)) refuse("the roll must be finite");
  for (std::size_t k = 0; k < clues.size(); ++k) {
    const PointingClue& clue = clues[k];
    if (!std::isfinite(clue.pixel.x) || !std::isfinite(clue.pixel.y) || !std::isfinite(clue.azimuth.value_or(0.0)))
      refuse(clueName(k) + " must have finite numbers");
    if (!clue.azimuth && !clue.elevation) refuse(clueName(k) + " has neither azimuth nor elevation");
    if (!(std::abs(clue.elevation.value_or(0.0)) <= 0.5 * kPi))
      refuse(clueName(k) + " has an elevation beyond 90 degrees");
  }
}

/// How many azimuths and elevations the clues tell.
struct Known {
  int azimuths = 0, elevations = 0;
};

Known knownOf(std::span<const PointingClue> clues) {
  Known known;
  for (const PointingClue& clue : clues) {
    if (clue.azimuth) ++known.azimuths;
    if (clue.elevation) ++known.elevations;
  }
  return known;
}

/// Refuses clues that cannot be enough, whatever their numbers.
void requireEnough(const Known& known, bool rollGiven) {
  if (known.azimuths == 0)
    refuse("no clue has an azimuth; the sun's place, or another direction with its azimuth, must be added");
  const int angles = known.azimuths + known.elevations + (rollGiven ? 1 : 0);
  if (angles < 3)
    refuse("the clues tell " + std::to_string(angles) + " of the 3 angles of a camera; " +
           (rollGiven ? "an elevation" : "the roll, another direction or points of the horizon") + " must be added");
}

void refuseCoincidences(std::span<const PointingClue> clues) {
  const auto direction = [](const PointingClue& clue) { return skyDirection(*clue.azimuth, *clue.elevation); };
  for (std::size_t i = 0; i < clues.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const PointingClue &a = clues[k], &b = clues[i];
      const bool sameKind = (a.azimuth && b.azimuth) || (a.elevation && b.elevation);
      if (sameKind && glm::distance(a.pixel, b.pixel) < kSamePlace)
        refuse(clueName(k) + " and " + clueName(i) + " are at the same place in the picture");
      if (a.azimuth && a.elevation && b.azimuth && b.elevation &&
          angleBetween(direction(a), direction(b)) < kSameSighting)
        refuse(clueName(k) + " and " + clueName(i) + " are the same direction in the sky");
    }
  }
}

std::vector<Sighting> sightingsOf(const Camera& camera, std::span<const PointingClue> clues) {
  std::vector<Sighting> sightings;
  for (std::size_t k = 0; k < clues.size(); ++k) {
    const auto inCamera = camera.directionAt(clues[k].pixel);
    if (!inCamera) refuse(clueName(k) + " lies where the lens shows no sky");
    sightings.push_back({glm::normalize(*inCamera), clues[k].azimuth, clues[k].elevation});
  }
  return sightings;
}

/// One elevation and a given roll leave nothing to balance: the camera can have seen that elevation there, or not.
void requireSeen(std::span<const Sighting> sightings, double roll) {
  for (std::size_t k = 0; k < sightings.size(); ++k) {
    if (!sightings[k].elevation) continue;
    const auto [least, most] = elevationsSeen(sightings[k].inCamera, roll);
    if (*sightings[k].elevation >= least - kBorderSlack && *sightings[k].elevation <= most + kBorderSlack) continue;
    refuse("with this roll, what is at the place of " + clueName(k) + " has an elevation from " + inDegrees(least) +
           " to " + inDegrees(most) + " degrees, not " + inDegrees(*sightings[k].elevation));
  }
}

/// Refuses what the clues leave open: the squared errors of the three turns, for an error of 1 rad of every clue.
void requireDetermined(const MissSum& sum) {
  const Mat3 variances = glm::inverse(sum.curvature);
  const double gain = variances[0][0] + variances[1][1] + variances[2][2];
  if (!(gain > 0.0 && gain < kMostErrorGain * kMostErrorGain))
    refuse(
        "the clues leave the camera free to turn: they are too close together, opposite each other or at the zenith; "
        "another direction or a point of the horizon must be added");
}

/// Pixels from a place to where a direction belongs, or to the line of an elevation or azimuth, straight for the short
/// way there.
double pixelsOff(const Camera& camera, const PointingClue& clue, const Sighting& sighting, double angle) {
  const double byAngle = angle * camera.focalLength();
  if (sighting.isDirection()) {
    const auto place = camera.placeOf(skyDirection(*clue.azimuth, *clue.elevation));
    return place ? glm::distance(*place, clue.pixel) : byAngle;
  }
  const auto missAt = [&](double x, double y) {
    const auto toSky = camera.directionAt(clue.pixel + Vec2(x, y));
    return toSky ? missOf(sighting, *toSky).angle : std::numeric_limits<double>::quiet_NaN();
  };
  const Vec2 slope =
      Vec2(missAt(kSlopeReach, 0.0) - missAt(-kSlopeReach, 0.0), missAt(0.0, kSlopeReach) - missAt(0.0, -kSlopeReach)) /
      (2.0 * kSlopeReach);
  const double steepness = glm::length(slope);
  return steepness > 0.0 ? angle / steepness : byAngle;
}

double rms(const std::vector<PointingResidual>& residuals, double PointingResidual::*member) {
  double squares = 0.0;
  for (const PointingResidual& residual : residuals) squares += residual.*member * residual.*member;
  return residuals.empty() ? 0.0 : std::sqrt(squares / static_cast<double>(residuals.size()));
}

}  // namespace

double Pointing::rmsAngle() const { return rms(residuals, &PointingResidual::angle); }
double Pointing::rmsPixels() const { return rms(residuals, &PointingResidual::pixels); }

Pointing findPointing(const CameraSettings& lens, std::span<const PointingClue> clues, std::optional<double> roll) {
  validate(clues, roll);
  const Known known = knownOf(clues);
  requireEnough(known, roll.has_value());
  refuseCoincidences(clues);
  const Camera camera = unturned(lens);
  const std::vector<Sighting> sightings = sightingsOf(camera, clues);
  if (roll && known.azimuths == 1 && known.elevations == 1) requireSeen(sightings, *roll);

  const auto [angles, sum] = fitPointing(sightings, roll, 1.0 / camera.focalLength());
  requireDetermined(sum);
  CameraSettings turned = lens;
  // An exact operation, so that a camera's azimuth does not grow by whole turns.
  turned.azimuth = std::remainder(angles.azimuth, 2.0 * kPi);
  turned.elevation = angles.elevation;
  turned.roll = angles.roll;

  const Camera found(turned);
  Pointing pointing{turned.azimuth, turned.elevation, turned.roll, {}};
  for (std::size_t k = 0; k < clues.size(); ++k) {
    const double angle = std::abs(missOf(sightings[k], cameraToWorld(angles) * sightings[k].inCamera).angle);
    if (angle > kContradiction)
      refuse("the clues contradict each other: with the best camera " + clueName(k) + " is " + inDegrees(angle) +
             " degrees off");
    pointing.residuals.push_back({angle, pixelsOff(found, clues[k], sightings[k], angle)});
  }
  return pointing;
}

}  // namespace parhelion
