// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "photo/halo_lookup.h"
#include "photo/photo_camera.h"
#include "render/scene_attributes.h"
#include "render/traced_sky.h"

namespace parhelion {

// Where the halo for a photograph comes from: a scene that is rendered into the photograph's camera, or the picture of
// a render.

/// The halo as a photograph's camera sees it.
struct PhotoHalo {
  HaloLookup lookup;
  ExrAttributes attributes;  // with the scene of the whole picture: this camera, this sun
};

/// Loads a scene, with these overrides after all others. Throws SceneError.
using SceneLoader = std::function<LoadedScene(const std::vector<std::string>& overrides)>;

/// A scene seen by a photograph's camera, with the sun where that saw it.
struct HaloScene {
  LoadedScene whole;      // in the photograph's pixels
  LoadedScene coarse;     // in larger ones: what is to be rendered
  CameraSettings camera;  // of the latter
};

/// `coarseness` is the side of the halo's pixels in the photograph's; none: as coarse as the sun's disc allows.
HaloScene haloSceneFor(const PhotoCamera& camera, std::optional<int> coarseness, const SceneLoader& load);

/// The halo from `scene.coarse`. `threads` 0: one a processor.
PhotoHalo haloOf(const TracedSky& traced, const HaloScene& scene, const PhotoCamera& camera, int threads);

/// The sun's elevation in the picture of a sky, rad. Throws std::runtime_error if it does not tell.
double sunElevationIn(const std::filesystem::path& sky);

/// The halo from a sky that was rendered before, by any camera. Throws std::runtime_error if it is none, or its sun was
/// at another elevation.
PhotoHalo readHalo(const std::filesystem::path& sky, const PhotoCamera& camera,
                   EditedPictures edited = EditedPictures::refused);

}  // namespace parhelion
