// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "crystal/population_settings.h"
#include "optics/light_settings.h"
#include "recon/recon_settings.h"
#include "sky/camera_settings.h"
#include "trace/trace_settings.h"

namespace parhelion {

/// All that a scene file says, validated; what it leaves out has the defaults of these structs.
struct Scene {
  SunSettings sun;
  IceSettings ice;
  std::vector<PopulationSettings> populations;  // at least one
  CameraSettings camera;
  TraceSettings trace;
  ReconSettings recon;
};

}  // namespace parhelion
