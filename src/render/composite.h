// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "photo/added_halo.h"
#include "photo/photo_camera.h"
#include "picture/transaction.h"
#include "render/scene_attributes.h"

namespace parhelion {

/// All of a photograph as sky.
SkyMask allSky(const Photograph& photograph);

/// The sky found in a photograph, above its camera's horizon. `threads` 0: one a processor.
SkyMask findSkyAbove(const Photograph& photograph, const CameraSettings& camera, int threads);

/// A photograph's sky from a file. Throws std::runtime_error "path: reason", also if it has another size.
SkyMask readSkyMaskOf(const Photograph& photograph, const std::filesystem::path& path);

/// What a composite is made of and becomes.
struct CompositeFiles {
  std::filesystem::path photo;          // the file of the photograph
  std::filesystem::path output;         // .png, .jpg, .jpeg or .exr
  std::filesystem::path editingFolder;  // of pictures for editing; empty: none
  std::filesystem::path foundMask;      // where to write the mask; empty: not at all
  Transaction* run = nullptr;           // with whose other files they appear; none: each by itself
};

/// The pictures for editing, in the folder `editingFolder`; none if that is empty.
std::vector<std::filesystem::path> editingFiles(const std::filesystem::path& editingFolder);

/// Adds the halo to the photograph and writes all files, the composite with `attributes` of the halo (PhotoHalo) and
/// its strength. A JPEG out of a JPEG keeps what the halo does not touch; an EXR holds light beyond white. `threads` 0:
/// one a processor. Throws std::runtime_error.
AddedHaloReport writeComposite(const CompositeFiles& files, Photograph photograph, const AddedHalo& added,
                               const PhotoCamera& camera, const ExrAttributes& attributes, int threads);

}  // namespace parhelion
