// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "air/air_settings.h"
#include "crystal/population_settings.h"
#include "optics/light_settings.h"
#include "recon/recon_settings.h"
#include "sky/camera_settings.h"
#include "trace/haze_settings.h"
#include "trace/slab_settings.h"
#include "trace/trace_settings.h"

namespace parhelion {

/// All that a scene file says, validated; what it leaves out has the defaults of these structs.
struct Scene {
  SunSettings sun;
  IceSettings ice;
  std::vector<PopulationSettings> populations;  // at least one
  std::vector<HazeSettings> hazes;              // beside them
  std::optional<SlabSettings> cloud;            // none: single crystals, in units of the light that they intercept
  CameraSettings camera;
  SkySettings sky;
  ObserverSettings observer;
  TraceSettings trace;
  ReconSettings recon;
};

}  // namespace parhelion
