// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/run_options.h"
#include "cli/stats.h"
#include "render/halo_source.h"

namespace parhelion::cli {

/// A halo, and what is told of its run if it was rendered.
struct MadeHalo {
  PhotoHalo halo;
  std::optional<RunFigures> figures;
};

/// Where the halo for a photograph comes from: a scene that is rendered into the photograph's camera, or the picture of
/// a render.
struct HaloOptions {
  RunOptions run;       // its scene is that of --scene
  std::string picture;  // of --halo
  std::optional<int> coarseness;

  void addTo(CLI::App& command);

  /// Throws CLI::ValidationError unless one of the two is given, and if options of one come with the other.
  void requireOne() const;

  const std::string& file() const { return picture.empty() ? run.scene : picture; }

  /// What the scene says of the sun, rad.
  double sunElevation() const;

  /// Memory for rendering the halo of this camera, bytes; 0 where there is nothing to be rendered.
  std::uint64_t memoryFor(const PhotoCamera& camera) const;

  /// The halo as this camera sees it, with the sun where it saw it. Throws std::runtime_error, SceneError.
  MadeHalo make(const PhotoCamera& camera, EditedPictures edited) const;

 private:
  HaloScene sceneFor(const PhotoCamera& camera) const;
  MadeHalo render(const PhotoCamera& camera) const;
};

}  // namespace parhelion::cli
