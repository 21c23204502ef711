// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "crystal/shapes.h"
#include "entry_sampler.h"
#include "orientations.h"
#include "random_stream.h"
#include "trace/cloud.h"
#include "trace/light_path.h"
#include "trace/trace.h"

namespace parhelion::test {

inline PopulationSettings prismPopulation(double aspect, const OrientationSettings& orientation = RandomOrientation{}) {
  PopulationSettings population;
  population.shape = PrismSettings{FixedValue{aspect}};
  population.orientation = orientation;
  return population;
}

/// A cloud under a monochromatic point sun.
inline Cloud simpleCloud(const std::vector<PopulationSettings>& populations, double sunElevation = radians(20.0),
                         double index = 1.31) {
  SunSettings sun;
  sun.elevation = sunElevation;
  sun.diameter = 0.0;
  sun.spectrum = MonochromaticSpectrum{550.0};
  return Cloud(sun, ConstantIndex{index}, populations);
}

/// An engine for one mesh.
inline Intersector intersectorOf(const CrystalMesh& mesh, Engine engine) {
  EngineDevices devices;
  return makeIntersector(engine, mesh, devices);
}

inline std::optional<FaceHit> nextFace(const Intersector& engine, const Crystal& crystal, const Vec3& point,
                                       const Vec3& lightDir, int leftFace) {
  return std::visit([&](const auto& e) { return e.nextFace(crystal, point, lightDir, leftFace); }, engine);
}

/// A unit vector, uniform over the sphere.
inline Vec3 randomDirection(RandomStream& random) {
  const double u1 = random.next(), u2 = random.next();
  return crystalOrientation(2.0 * std::asin(std::sqrt(u1)), 2.0 * kPi * u2, 0.0)[2];
}

/// Light along `lightDir` (crystal frame) that meets `crystal` at a given point of a face.
inline LightPath lightAt(const Crystal& crystal, const Vec3& lightDir, int face, const Vec3& point, std::uint64_t index,
                         double iceIndex = 1.31) {
  LightPath path;
  path.incident.index = path.incident.bundle = index;
  path.incident.crystal = crystal;
  path.incident.lightDirWorld = path.incident.lightDirCrystal = lightDir;
  path.incident.entry = {face, point};
  path.incident.iceIndex = iceIndex;
  return path;
}

inline double outgoing(const LightPath& path) {
  double sum = 0.0;
  for (const Exit& exit : path.exits) sum += exit.energy;
  return sum;
}

}  // namespace parhelion::test
