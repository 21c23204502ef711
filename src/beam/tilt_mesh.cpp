// SPDX-License-Identifier: Apache-2.0
#include "beam/tilt_mesh.h"

#include <algorithm>
#include <cmath>

#include "beam/band_store.h"
#include "beam/tilt_integral.h"

namespace parhelion {

namespace {

// The first mesh: cells for 30 degrees of azimuth that light is traced at, parts of continuous light, rows of the sun's
// disc. Cells over what the picture and the sun blur; their bounds, rad.
constexpr int kColumns = 40, kLights = 4, kFewestSunRows = 3;
constexpr double kSunRows = 1.5;  // to a disc's radius in cells
constexpr double kOfBlur = 0.7, kOfDisc = 0.6, kFinest = 0.0012, kCoarsest = 0.0045;
// Thickness of bands over half of what tilts are spread by; at most over cells, and in rad.
constexpr double kOfSpread = 0.5, kThickest = 2.2, kThickestBand = 0.0055;
// Each mesh has cells smaller than the last one by this.
constexpr double kFiner = 1.5;
// The last one is not made where it would be finer by less than this.
constexpr double kWorthwhile = 1.25;

}  // namespace

double blurOf(const Camera& camera, double sunRadius) {
  return std::max(1.0 / camera.focalLength(), kOfDisc * sunRadius);
}

/// Size of rings and of cells along them, rad.
double cellOf(double blur, int level) {
  return std::max(std::min(kOfBlur * blur, kCoarsest) / std::pow(kFiner, level), kFinest);
}

int sunRowsOf(double radius, int cells) {
  return std::max(kFewestSunRows, static_cast<int>(std::ceil(kSunRows * radius * cells / kPi)));
}

BandMesh tiltMeshOf(double cell, double spread, int level) {
  const double thick = std::clamp(kOfSpread * spread / std::pow(kFiner, level), cell,
                                  std::max(std::min(kThickest * cell, kThickestBand), cell));
  BandMesh mesh;
  mesh.bands = 2 * static_cast<int>(std::ceil(0.25 * kPi / thick));
  mesh.cells = 4 * static_cast<int>(std::ceil(0.25 * kPi / cell));
  mesh.rings = mesh.end = mesh.cells;
  return mesh;
}

int tiltColumnsAt(int level) { return 2 * static_cast<int>(std::lround(0.5 * kColumns * std::pow(kFiner, level))); }

int tiltLightsAt(int level) { return kLights + 2 * level; }

bool isFinestMesh(const Camera& camera, double sunRadius, int level) {
  const double blur = blurOf(camera, sunRadius);
  return level == kTiltLevels.most || cellOf(blur, level) < kWorthwhile * cellOf(blur, level + 1);
}

bool isForTilts(const AxisScene& scene, const Camera& camera) {
  const bool blurs = !scene.oneTilt || scene.sun.radius > 0.0;
  return blurs && kOfBlur * blurOf(camera, scene.sun.radius) >= kFinest;
}

std::uint64_t memoryForTilts(const Camera& camera, double sunRadius, double error) {
  const int level = std::min(kTiltLevels.firstFor(error) + 1, kTiltLevels.most);
  const double cells = kPi / cellOf(blurOf(camera, sunRadius), level), square = cells * cells,
               rows = sunRadius > 0.0 ? sunRowsOf(sunRadius, static_cast<int>(cells)) : 1;
  // Four floats for each cell of rings: of pieces of work, of each elevation of the sun twice; for each order, of bands
  // and of elevations, of which there are less near the sun.
  constexpr double kBytes = 16.0, kPieces = 4.0, kShareOfOrders = 0.7;
  constexpr auto kMade = static_cast<double>(BandStore::kAtOnce);
  return static_cast<std::uint64_t>(kBytes * square * (kPieces + 2.0 * rows + kShareOfOrders * (kMade + rows)));
}

double workOf(const MeshWork& mesh) {
  constexpr double kTraced = 32e-6,  // a direction of light
      kCell = 60e-6,                 // a cell of azimuth and a part of the light, of one band
      kOfRings = 28e-9,              // a cell of the rings, of one band
      kLookUp = 0.19e-6;             // of a pixel, by one point of the sun
  const double bands = mesh.bands, cells = mesh.cells;
  const double side = std::max(1.0, std::ceil(std::sqrt(0.5) * mesh.pixel * cells / kPi));
  return kTraced * (bands + 1.0) * mesh.columns * mesh.indices * mesh.prisms +
         bands * (kCell * mesh.columns * mesh.lights + kOfRings * mesh.rings * cells) +
         kLookUp * mesh.pixels * mesh.sunRows * mesh.sunRows * side;
}

/// How much more work a mesh and so many finer ones are than the mesh alone.
double workOfLevels(int finer) {
  constexpr double kNext = 2.5;
  double all = 1.0, one = 1.0;
  for (int k = 0; k < finer; ++k) all += one *= kNext;
  return all;
}

}  // namespace parhelion
