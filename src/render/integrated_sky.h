// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "beam/light_store.h"
#include "picture/image.h"
#include "render/prism_populations.h"
#include "scene/parse_scene.h"
#include "sky/tally_info.h"

namespace parhelion {

/// A sky without any ray: integrated over all orientations.
struct IntegratedSky {
  Image image;           // R, G, B and the variance of the luminance, as reconstructions have them
  TallyInfo info;        // without rays; its light is in units of all that is intercepted
  double error = 0.0;    // of the picture, as pictureError() has it
  double cutOff = 0.0;   // share of the light
  long directions = 0;   // of light in a crystal that were traced
  long sheets = 0;       // of orientations
  bool reached = true;   // the error aimed at
  bool refused = false;  // it was not to go on, and this is no picture
};

/// What keeps a scene's sky from being integrated, in one line; empty if nothing does.
std::string objectionToIntegratedSky(const Scene& scene);

/// Bytes that integrating a scene's sky takes beside its pixels, at most.
std::uint64_t memoryOfOrientations(const Scene& scene, double error);

/// Integrates the sky of a scene that has no objection until the picture's error is at most so much. The same bits for
/// any number of threads. Throws std::invalid_argument for a scene that has one. A store serves the next pictures; it
/// changes no bit. Where energy counts all three colours are the same. `goOn` as SkyAccuracy has it.
IntegratedSky integrateSky(const LoadedScene& loaded, double error, LightStore* store = nullptr,
                           Counted counted = Counted::colour, const std::function<bool(double)>& goOn = {});

}  // namespace parhelion
