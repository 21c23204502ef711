// SPDX-License-Identifier: Apache-2.0
#include "cli/view_layers.h"

#include <algorithm>
#include <optional>

#include "crystal/raypath/halo_paths.h"
#include "picture/picture_layers.h"
#include "scene/parse_scene.h"
#include "sky/sky_tally.h"
#include "view/layer_places.h"

namespace parhelion::cli {

namespace {

/// The halo whose light is in a layer, or the layer's own name.
std::string nameOfLayer(const std::string& layer, const std::vector<LayerSettings>& settings) {
  for (const LayerSettings& one : settings)
    if (one.name == layer && one.paths)
      if (const auto halos = halosNamed(one.paths->text); !halos.empty()) return std::string(halos.front()->name);
  return layer;
}

}  // namespace

std::vector<LayerSettings> namedLayers(const std::string& scene, const std::string& file) {
  std::vector<LayerSettings> layers = parseScene(scene, file).scene.trace.paths.layers;
  if (std::ranges::none_of(layers, [](const LayerSettings& one) { return one.paths.has_value(); })) layers.clear();
  return layers;
}

std::vector<NamedPlace> layerNames(const ViewInput& input, const CameraSettings& camera,
                                   const std::vector<std::string>& wanted, const OverlaySettings& overlay) {
  const auto scene = input.scene();
  if (!overlay.halos || !overlay.labels || input.layers.channels.empty() || !scene) return {};
  const std::vector<LayerSettings> settings = namedLayers(*scene, input.sceneFile);
  const Camera shown(camera);
  std::vector<NamedPlace> names;
  for (const std::string& layer : layersOf(input.layers)) {
    const bool isWanted = wanted.empty() ? layer != kRestLayer : std::ranges::find(wanted, layer) != wanted.end();
    if (!isWanted) continue;
    if (const auto place = brightestPlace(input.layers, layer, shown, overlay.belowHorizon))
      names.push_back({nameOfLayer(layer, settings), *place});
  }
  return names;
}

}  // namespace parhelion::cli
