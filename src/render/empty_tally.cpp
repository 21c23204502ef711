// SPDX-License-Identifier: Apache-2.0
#include "render/empty_tally.h"

namespace parhelion {

Tally emptyTally(const LoadedScene& loaded, const Cloud& cloud, const std::string& version) {
  const Scene& scene = loaded.scene;
  TallyInfo info;
  info.seed = scene.trace.seed;
  info.white = cloud.spectrum().white();
  info.sunElevation = scene.sun.elevation;
  info.sunDiameter = scene.sun.diameter;
  info.camera = scene.camera;
  info.scene = loaded.text;
  info.version = version;
  return Tally(info, cloud.spectrum().colours());
}

}  // namespace parhelion
