// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "beam/band_store.h"
#include "beam/crystal_side.h"
#include "beam/light_segments.h"
#include "beam/prism_section.h"
#include "beam/scatter_scene.h"
#include "beam/sheet_totals.h"
#include "beam/sun_points.h"
#include "beam/wanted_paths.h"
#include "math/rotation_columns.h"
#include "sky/camera.h"

namespace parhelion {

/// Prisms of all azimuths under a sun: their c axes have a distribution of tilts and they all rolls, or they stand
/// alike otherwise. All functions take numbers in (0, 1), over which they are distributions.
struct AxisScene {
  std::vector<PrismShare> prisms;             // shares of their surface
  std::vector<double> indices;                // at which light is traced; all others lie between them
  std::function<double(double)> tilt;         // of c from the zenith, rad
  std::function<Vec3(double, double)> toSun;  // points of the disc: unit, world
  std::function<IndexColour(double)> light;   // means of colours are that of white light
  std::vector<IndexColour> lines;             // all there is of it, each as likely; empty for continuous light
  SunFace sun;
  bool oneTilt = false;
  std::optional<RotationColumns<double>> rest;  // of crystals that stand alike: to the world, at azimuth 0
  PrismSection section;                         // of those; of all others it is regular
  bool isMirrored = true;                       // the light is its own mirror image in the sun's vertical plane
  CrystalSide side = CrystalSide::both;
  // Light that counts, by faces of a crystal whose upper end it meets; of crystals that stand alike by their own.
  const WantedPaths* wanted = nullptr;

  /// Whether light of one place differs in more than its brightness from that of another.
  bool hasColours() const {
    return lines.empty() ||
           std::ranges::any_of(lines, [&](const IndexColour& line) { return line.xyz != lines.front().xyz; });
  }

  /// All lines if there are any, else all light in so many parts.
  LightSegments segments(int parts) const {
    return lines.empty() ? LightSegments::of(light, static_cast<std::size_t>(parts)) : LightSegments::ofLines(lines);
  }
};

/// How well it is to be integrated, and for which picture.
struct SkyAccuracy {
  double error = 0.01;     // aimed at: the pixels' errors together over their light together
  double cutShare = 1e-5;  // PrismTracer
  std::uint64_t seed = 1;
  bool folds = false;    // the picture's left half is the mirror image of its right
  bool hasEdge = false;  // SheetMesh
  double widest = -2.0;  // SheetMesh
  /// Asked before each mesh, with the work that is left (tilt_mesh.h): whether to go on. Empty: always.
  std::function<bool(double)> goOn;
};

/// The light of a picture's pixels, per surface of the crystals (their mean shadows).
struct SkyIntegral {
  std::vector<std::array<float, 3>> xyz;  // of each pixel
  std::vector<float> variance;            // of its Y
  SheetTotals totals;
  double error = 0.0;   // as SkyAccuracy has it
  long directions = 0;  // traced
  long sheets = 0;
  bool reached = false;
  bool refused = false;  // it was not to go on, and this is no result
};

/// Integrates over all orientations. The same bits for any number of threads, and whatever the store has.
SkyIntegral integrateSky(const AxisScene& scene, const SkyAccuracy& accuracy, const Camera& camera, BandStore& store);

}  // namespace parhelion
