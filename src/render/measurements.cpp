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

Image mapPicture(const LightMap& map) {
  const int columns = map.grid.columns(), rows = map.grid.rows();
  Image image{columns, rows, {}};
  image.add("Y");
  image.add("stderr");
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const auto bin = static_cast<std::size_t>(map.grid.bin(column, row)),
                 pixel = static_cast<std::size_t>(map.grid.bin(column, rows - 1 - row));
      image.channels[0].samples[pixel] = static_cast<float>(map.energy[bin]);
      image.channels[1].samples[pixel] = static_cast<float>(map.error[bin]);
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
