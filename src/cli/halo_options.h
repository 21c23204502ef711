// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "cli/run_options.h"
#include "picture/transaction.h"
#include "render/halo_source.h"

namespace parhelion::cli {

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

  /// The halo as this camera sees it, with the sun where it saw it; figures of the run go to `outputs`. Throws
  /// std::runtime_error, SceneError.
  PhotoHalo make(const PhotoCamera& camera, EditedPictures edited, Transaction& outputs) const;

 private:
  PhotoHalo render(const PhotoCamera& camera, Transaction& outputs) const;
};

}  // namespace parhelion::cli
