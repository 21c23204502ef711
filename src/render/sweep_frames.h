// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "picture/gamut.h"
#include "render/frame_names.h"
#include "scene/parse_scene.h"

namespace parhelion {

/// A picture of a sweep.
struct SweepFrame {
  std::vector<std::string> values;  // "key=value" of the keys that are swept
  LoadedScene loaded;
  std::filesystem::path exr;
  Gamut gamut = Gamut::exact;
  std::string lacks;  // why it must be rendered; empty: the file is the picture already

  std::filesystem::path png() const { return std::filesystem::path(exr).replace_extension(".png"); }

  /// "sun.elevation=12, trace.seed=3"
  std::string valuesText() const;
};

/// Loads the scene of a frame by its values, with the error that it is integrated to if it is. Throws SceneError.
using FrameLoader = std::function<LoadedScene(const std::vector<std::string>& values)>;

/// The frames in order, numbered from `first`, each with its scene validated, and its file looked at if there is one.
/// Throws SceneError for the first scene that cannot be used, and, unless `overwrite`, std::runtime_error for a file in
/// the place of a frame or its preview that no render has written.
std::vector<SweepFrame> planFrames(std::span<const std::vector<std::string>> values, const FrameLoader& load,
                                   const FrameNames& names, std::size_t first, Gamut gamut = Gamut::exact,
                                   bool overwrite = false);

}  // namespace parhelion
