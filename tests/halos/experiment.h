// SPDX-License-Identifier: Apache-2.0
#pragma once

// Small clouds to experiment on, and a look at single rays with the faces they have met.

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "math/rotation.h"
#include "statistics.h"
#include "trace/light_path.h"
#include "trace/trace.h"

namespace parhelion {

inline constexpr double kIndex = 1.31;  // of the ice in all tests that do not say otherwise

inline PopulationSettings prisms(double aspect, const OrientationSettings& orientation, double weight = 1.0) {
  return {"prisms", weight, PrismSettings{FixedValue{aspect}}, orientation};
}

// Perfectly oriented crystals; free where the settings' defaults are.
inline OrientationSettings plateOrientation() { return AxisOrientation{}; }
inline constexpr UniformRange kFree{0.0, 2.0 * kPi};
inline OrientationSettings columnOrientation() { return AxisOrientation{FixedValue{0.5 * kPi}, kFree, kFree}; }
inline OrientationSettings parryOrientation() { return AxisOrientation{FixedValue{0.5 * kPi}, kFree, FixedValue{}}; }

/// Crystals under a point sun at `sunElevation` (rad), in light of one wavelength.
inline Cloud cloudUnderPointSun(double sunElevation, const std::vector<PopulationSettings>& populations,
                                const IceSettings& ice = ConstantIndex{kIndex}, double wavelength = 550.0) {
  return Cloud({sunElevation, 0.0, MonochromaticSpectrum{wavelength}, false}, ice, populations);
}

/// Calls `look` with each of the first `rays` light paths, encounters recorded, one after the other.
template <class Look>
void forEachRay(const Cloud& cloud, std::uint64_t rays, Look&& look, const TraceSettings& settings = {}) {
  const Intersectors engines = makeIntersectors(cloud, settings.engine);
  RaySource source(cloud, settings, 256);
  LightPath path;
  path.recordEncounters = true;
  for (std::uint64_t index = 0; index < rays; ++index) {
    followRay(source, engines, settings, index, path);
    look(static_cast<const LightPath&>(path));
  }
}

/// Light that has gone in through one face and straight out through another.
struct DirectLight {
  int in, out;  // crystallographic face numbers
  Vec3 lightDirWorld;
  double energy;
  const IncidentRay& incident;
};

/// Calls `look` with the direct light of each of the first `rays` light paths that has any.
template <class Look>
void forDirectLight(const Cloud& cloud, std::uint64_t rays, Look&& look) {
  forEachRay(cloud, rays, [&](const LightPath& path) {
    for (const Exit& exit : path.exits)
      if (exit.order == 1)
        look(DirectLight{path.encounters[0].faceNumber, path.encounters[1].faceNumber, exit.lightDirWorld, exit.energy,
                         path.incident});
  });
}

inline bool isBasal(int face) { return face == 1 || face == 2; }
inline bool isPrism(int face) { return face >= 3 && face <= 8; }

/// Prism faces that make a wedge of 60 degrees: next but one to each other.
inline bool isWedge60(int in, int out) {
  const int apart = (out - in + 6) % 6;
  return isPrism(in) && isPrism(out) && (apart == 2 || apart == 4);
}

/// Where the eye sees the light, degrees.
struct SkyDegrees {
  double azimuth, elevation;
};
inline SkyDegrees seenAt(const Vec3& lightDirWorld) {
  const SkyPoint sky = skyPoint(-lightDirWorld);
  return {degrees(sky.azimuth), degrees(sky.elevation)};
}

/// Light over equal bins of one variable.
struct Histogram {
  double from, to;
  std::vector<double> energy;

  Histogram(double lowest, double highest, int bins) : from(lowest), to(highest), energy(bins) {}

  double width() const { return (to - from) / static_cast<double>(energy.size()); }
  double centre(int bin) const { return from + (bin + 0.5) * width(); }

  void add(double x, double light) {
    if (x >= from && x < to)
      energy[std::min(energy.size() - 1, static_cast<std::size_t>((x - from) / width()))] += light;
  }

  double total() const {
    double sum = 0.0;
    for (const double e : energy) sum += e;
    return sum;
  }

  /// Centre of the brightest bin.
  double peak() const {
    return centre(static_cast<int>(std::max_element(energy.begin(), energy.end()) - energy.begin()));
  }
};

}  // namespace parhelion
