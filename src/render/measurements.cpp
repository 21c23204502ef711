// SPDX-License-Identifier: Apache-2.0
#include "render/measurements.h"

#include "render/traced_sky.h"
#include "trace/engine.h"
#include "trace/ray_source.h"

namespace parhelion {

TraceSettings settingsOfMeasurement(const Cloud& cloud, const TraceSettings& asked) {
  TraceSettings settings = asked;
  settings.symmetry = Symmetry::none;
  settings.paths.layers.clear();
  return chosenSettings(cloud, settings);
}

Image mapPicture(const SkyMap& map) {
  Image image{map.columns(), map.rows(), {}};
  image.add("Y");
  image.add("stderr");
  for (int row = 0; row < map.rows(); ++row)
    for (int column = 0; column < map.columns(); ++column) {
      const std::size_t pixel = static_cast<std::size_t>(map.rows() - 1 - row) * map.columns() + column;
      image.channels[0].samples[pixel] = static_cast<float>(map.energy(column, row));
      image.channels[1].samples[pixel] = static_cast<float>(map.error(column, row));
    }
  return image;
}

LightPath replayRay(const Scene& scene, const Cloud& cloud, std::uint64_t ray) {
  LightPath path;
  path.recordEncounters = true;
  RaySource source(cloud, scene.trace, 1);
  followRay(source, makeIntersectors(cloud, scene.trace.engine), scene.trace, ray, path);
  return path;
}

}  // namespace parhelion
