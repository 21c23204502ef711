// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/run_options.h"
#include "cli/stop_signal.h"
#include "picture/auto_exposure.h"
#include "picture/gamut.h"
#include "render/sky_files.h"
#include "scene/scene.h"

namespace parhelion::cli {

/// The words of a command line for how linear light is shown.
struct DisplayWords {
  std::optional<double> exposure;       // stops
  std::optional<double> exposureValue;  // EV at ISO 100
  std::string tone;                     // name of a curve; empty: the usual one

  /// Adds --exposure, of which `about` says what it is, --ev and --tone.
  void addTo(CLI::App& command, const std::string& about);

  LightDisplay settings() const;
};

/// Where a picture goes and how its preview is exposed.
struct PictureOptions {
  std::string output;    // of the EXR; empty: named after the input, in the current folder
  DisplayWords display;  // of the preview
  std::string gamut;     // "exact", "clip"; empty: exact

  void addTo(CLI::App& command);

  /// The EXR and the preview beside it, for input file `input`; in the folder `output` if that is one. Throws
  /// CLI::ValidationError if `output` has another extension than .exr or .png, or is a pipe, which two files cannot go
  /// to, and where there is no name to call them by.
  SkyFiles files(const std::string& input) const;
};

/// Throws CLI::ValidationError for an exposure value of a scene whose pictures are not in absolute units.
void requireUnit(const LightDisplay& display, const Scene& scene);

/// Adds --gamut, which says what becomes of colours outside Rec.709, to a subcommand.
void addGamut(CLI::App& command, std::string& gamut);

/// A watch on the walks through a cloud: progress on stderr, and stopping where there is a StopSignal.
WalkWatch walkWatch(const RunOptions& options, const StopSignal* stop);

/// What --gamut says.
Gamut gamutOf(const std::string& gamut);

/// Says on stderr what was written, and what the reconstruction remarked.
void reportPicture(const SkyFiles& files, const WrittenSky& written, const std::vector<std::string>& remarks);

}  // namespace parhelion::cli
