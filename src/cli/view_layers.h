// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/view_input.h"
#include "sky/camera_settings.h"
#include "trace/path_settings.h"
#include "view/overlay.h"

namespace parhelion::cli {

/// The layers of a scene, of which `file` is what errors call it, whose pictures are to name them: none where no layer
/// has paths, as then the names of halos say more.
std::vector<LayerSettings> namedLayers(const std::string& scene, const std::string& file);

/// The names of an EXR's layers, each at the place where the layer's own light is brightest; of those `wanted`, or of
/// all but the rest. A layer of a halo's light has the halo's name. Empty where readViewInput() has kept no layers to
/// be named, and where the overlay has no names of halos.
std::vector<NamedPlace> layerNames(const ViewInput& input, const CameraSettings& camera,
                                   const std::vector<std::string>& wanted, const OverlaySettings& overlay);

}  // namespace parhelion::cli
