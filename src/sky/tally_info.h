// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "math/conventions.h"
#include "math/sum_visitor.h"
#include "sky/camera_settings.h"
#include "sky/fixed_point.h"
#include "sky/ray_ranges.h"

namespace parhelion {

/// What exact sums were made of, be they of a picture, a map or a profile. Sums may be added where all of this but the
/// rays and the texts is the same.
struct TallyOrigin {
  std::uint64_t sceneHash = 0;  // of all that decides what becomes of a ray, but for the seed (scene/traced_keys.h)
  int numerics = 0;             // version of the tracing's arithmetic (trace/numerics.h)
  std::uint64_t seed = 0;
  RayRanges rays;       // traced so far
  std::string scene;    // the whole scene file, overrides applied
  std::string version;  // of the program that traced

  bool operator==(const TallyOrigin&) const = default;

  /// The number of rays in all ranges together.
  std::uint64_t rayCount() const { return countOf(rays); }
};

/// What a ray counts for in a tally: for itself, for its mirror image in the sun's vertical plane, too, or for whole
/// rings about the sun.
enum class TallySymmetry { none, mirror, radial };

constexpr std::string_view nameOf(TallySymmetry value) {
  switch (value) {
    case TallySymmetry::none:
      return "none";
    case TallySymmetry::mirror:
      return "mirror";
    case TallySymmetry::radial:
      return "radial";
  }
  return {};
}

/// What a tally's sums were made of. With it, a reconstruction needs neither the scene nor the tracer.
struct TallyInfo : TallyOrigin {
  TallySymmetry symmetry = TallySymmetry::none;
  LightTotal intercepted;                    // light taken from the beam: per ray 1 on average, 2 if mirrored
  LightTotal undeviated;                     // the part of it that goes on in the sun's direction, in no pixel
  std::array<LightTotal, 3> interceptedXyz;  // `intercepted` in CIE XYZ over the white's: pixels can hold no more
  Vec3 white{1.0, 1.0, 1.0};                 // CIE XYZ of the undeviated sunlight, Y = 1
  double sunElevation = 0.0;                 // rad
  double sunDiameter = 0.0;                  // rad, 0 is a point
  CameraSettings camera;                     // its width and height are the tally's

  bool operator==(const TallyInfo&) const = default;

  /// Shows the totals of light.
  void visitTotals(SumVisitor& visitor);

  double interceptedLight() const { return intercepted.value(); }

  /// Undeviated over intercepted light, 0 before the first ray.
  double undeviatedFraction() const;

  /// Unit world vector toward the sun's centre.
  Vec3 toSun() const;

  /// For how many rays a ray counts: 1, or 2 with its mirror image.
  int images() const { return symmetry == TallySymmetry::mirror ? 2 : 1; }
};

/// Why the rays of one origin cannot be added to those of another, as "their seeds are 1 and 2"; empty if they can.
std::string objectionToAdding(const TallyOrigin& a, const TallyOrigin& b);

/// The same for tallies of pictures.
std::string objectionToAdding(const TallyInfo& a, const TallyInfo& b);

}  // namespace parhelion
