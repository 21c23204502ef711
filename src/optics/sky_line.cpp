// SPDX-License-Identifier: Apache-2.0
#include "optics/sky_line.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "math/portable.h"
#include "math/rotation.h"

namespace parhelion {
namespace {

// Steps in which a locus is first looked at; gaps and pieces shorter than one may go unseen.
constexpr int kCoarseSteps = 720;

// Halvings of a coarse step, down to 1e-9 rad: at the ends of a locus and where it runs fast.
constexpr int kHalvings = 23;

// Points on the smallest circle.
constexpr int kFewestPoints = 90;

/// Follows a locus from one end of its parameter to the other.
class Follower {
 public:
  explicit Follower(const SkyLocus& locus) : locus_(locus) {}

  std::vector<SkyLine> follow(double from, double to) {
    double t = from;
    std::optional<Vec3> here = locus_(from);
    for (int i = 1; i <= kCoarseSteps; ++i) {
      const double next = from + (to - from) * i / kCoarseSteps;
      const std::optional<Vec3> there = locus_(next);
      step(t, here, next, there, kHalvings);
      t = next;
      here = there;
    }
    return std::move(lines_);
  }

 private:
  void step(double t, const std::optional<Vec3>& a, double u, const std::optional<Vec3>& b, int halvings) {
    if (!a && !b) return;
    const bool close = a && b && glm::dot(*a - *b, *a - *b) < kSkyLineStep * kSkyLineStep;
    if (close) return join(*a, *b);
    if (halvings == 0) return;  // an end of the locus, or a gap in it
    const double middle = 0.5 * (t + u);
    const std::optional<Vec3> m = locus_(middle);
    step(t, a, middle, m, halvings - 1);
    step(middle, m, u, b, halvings - 1);
  }

  void join(const Vec3& a, const Vec3& b) {
    if (lines_.empty() || lines_.back().back() != a) lines_.push_back({a});
    lines_.back().push_back(b);
  }

  const SkyLocus& locus_;
  std::vector<SkyLine> lines_;
};

}  // namespace

std::vector<SkyLine> followLocus(double from, double to, const SkyLocus& locus) {
  return Follower(locus).follow(from, to);
}

std::vector<SkyLine> aboveHorizon(const SkyLine& line) {
  std::vector<SkyLine> pieces;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool isUp = line[i].z >= 0.0, wasUp = i > 0 && line[i - 1].z >= 0.0;
    if (i > 0 && isUp != wasUp) {
      const Vec3 &a = line[i - 1], &b = line[i];
      const Vec3 onHorizon = glm::normalize(a + a.z / (a.z - b.z) * (b - a));
      if (isUp) pieces.push_back({});
      pieces.back().push_back(onHorizon);
    }
    if (isUp && i == 0) pieces.push_back({});
    if (isUp) pieces.back().push_back(line[i]);
  }
  std::erase_if(pieces, [](const SkyLine& piece) { return piece.size() < 2; });
  return pieces;
}

SkyLine circleAbout(const Vec3& centre, double radius) {
  const SkyPoint at = skyPoint(centre);
  const auto [sinAz, cosAz] = portable::sincos(at.azimuth);
  const auto [sinEl, cosEl] = portable::sincos(at.elevation);
  const Vec3 up(-sinEl * cosAz, sinEl * sinAz, cosEl), right = glm::cross(centre, up);
  const auto [s, c] = portable::sincos(radius);
  const int steps = std::max(kFewestPoints, static_cast<int>(std::ceil(2.0 * kPi * s / kSkyLineStep)));
  SkyLine circle;
  for (int i = 0; i < steps; ++i) {
    const auto [sinTurn, cosTurn] = portable::sincos(2.0 * kPi * i / steps);
    circle.push_back(c * centre + s * (cosTurn * up + sinTurn * right));
  }
  circle.push_back(circle.front());
  return circle;
}

}  // namespace parhelion
