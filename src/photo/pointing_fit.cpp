// SPDX-License-Identifier: Apache-2.0
#include "photo/pointing_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "math/rotation.h"
#include "photo/pointing_starts.h"

namespace parhelion {
namespace {

// Damping of least squares, in units of a clue's own weight: at first little; at least so much that a turn which no
// clue resists stays finite; beyond the last no step is left that would make the sum smaller.
constexpr double kFirstDamping = 1e-3, kLeastDamping = 1e-12, kMostDamping = 1e6;
constexpr double kMoreDamping = 10.0, kLessDamping = 0.1;  // after a step that made the sum larger, and after others
constexpr double kLastStep = 1e-15;                        // rad: below it are the digits of the angles themselves
constexpr int kMaxSteps = 100;

// How much a camera that looks up is preferred to one that stands upright, where clues leave the choice: enough to
// decide for a camera that points to the zenith rather than to the nadir.
constexpr double kSkyward = 0.1;

/// Least squares over the three angles, or over azimuth and elevation alone.
class Solver {
 public:
  Solver(std::span<const Sighting> sightings, bool keepRoll) : sightings_(sightings), keepRoll_(keepRoll) {}

  /// Levenberg and Marquardt's way down from a start; quadratic where the clues can be fulfilled.
  PointingFit from(const CameraAngles& start) const {
    PointingFit now = at(start);
    double damping = kFirstDamping;
    for (int step = 0; step < kMaxSteps && damping <= kMostDamping; ++step) {
      const Vec3 turn = -(glm::inverse(now.sum.curvature + damping * Mat3(1.0)) * now.sum.slope);
      const PointingFit next = at(turned(now.angles, turn));
      if (!(next.sum.squares <= now.sum.squares)) {
        damping *= kMoreDamping;
        continue;
      }
      now = next;
      damping = std::max(kLeastDamping, kLessDamping * damping);
      if (glm::length(turn) < kLastStep) break;
    }
    return now;
  }

 private:
  /// The sums at some angles; with the roll kept, slopes without the turns that would change it or take the elevation
  /// out of its range.
  PointingFit at(const CameraAngles& angles) const {
    PointingFit fit{angles, missSum(sightings_, cameraToWorld(angles))};
    if (!keepRoll_) return fit;
    const Vec3 ahead = skyDirection(angles.azimuth, 0.0), right = rightOf(angles);
    Mat3 fixed = glm::outerProduct(ahead, ahead);
    const double rise = -glm::dot(fit.sum.slope, right);
    if ((angles.elevation >= 0.5 * kPi && rise > 0.0) || (angles.elevation <= -0.5 * kPi && rise < 0.0))
      fixed += glm::outerProduct(right, right);
    const Mat3 free = Mat3(1.0) - fixed;
    fit.sum.slope = free * fit.sum.slope;
    fit.sum.curvature = free * fit.sum.curvature * free + fixed;
    return fit;
  }

  /// The horizontal axis about which a camera is raised.
  static Vec3 rightOf(const CameraAngles& angles) { return skyDirection(angles.azimuth + 0.5 * kPi, 0.0); }

  CameraAngles turned(const CameraAngles& angles, const Vec3& turn) const {
    if (!keepRoll_) {
      // To first order, like the step itself; long steps become shorter ones.
      Mat3 world = cameraToWorld(angles);
      for (int k = 0; k < 3; ++k) world[k] += glm::cross(turn, world[k]);
      return anglesOf(world);
    }
    // Azimuth grows clockwise seen from above.
    return {angles.azimuth - turn.z,
            std::clamp(angles.elevation + glm::dot(turn, rightOf(angles)), -0.5 * kPi, 0.5 * kPi), angles.roll};
  }

  std::span<const Sighting> sightings_;
  bool keepRoll_;
};

/// How much likelier a camera is to have been held like this than otherwise, where the clues do not tell.
double preference(const CameraAngles& angles, bool rollGiven) {
  if (rollGiven) return -std::abs(angles.elevation);
  const Vec3 zenithInCamera = glm::transpose(cameraToWorld(angles))[2];
  return zenithInCamera.z + kSkyward * zenithInCamera.x;
}

}  // namespace

PointingFit fitPointing(std::span<const Sighting> sightings, std::optional<double> roll, double pixelAngle) {
  const Solver solver(sightings, roll.has_value());
  std::vector<PointingFit> fits;
  for (const CameraAngles& start : pointingStarts(sightings, roll)) fits.push_back(solver.from(start));
  const auto rms = [&](const PointingFit& fit) {
    return std::sqrt(fit.sum.squares / static_cast<double>(sightings.size()));
  };
  const auto best = std::min_element(fits.begin(), fits.end(),
                                     [&](const PointingFit& a, const PointingFit& b) { return rms(a) < rms(b); });
  const double enough = rms(*best) + pixelAngle;
  PointingFit preferred = *best;
  for (const PointingFit& fit : fits) {
    if (rms(fit) > enough) continue;
    if (preference(fit.angles, roll.has_value()) > preference(preferred.angles, roll.has_value())) preferred = fit;
  }
  return preferred;
}

}  // namespace parhelion
