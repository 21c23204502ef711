// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "picture/gamut.h"
#include "render/sky_files.h"

namespace parhelion::cli {

/// Where a picture goes and how its preview is exposed.
struct PictureOptions {
  std::string output;              // of the EXR; empty: named after the input, in the current folder
  std::optional<double> exposure;  // stops; empty: chosen by the picture
  std::string gamut;               // "exact", "clip"; empty: exact

  void addTo(CLI::App& command);

  /// The EXR and the preview beside it, for input file `input`; in the folder `output` if that is one. Throws
  /// CLI::ValidationError if `output` has another extension than .exr or .png, or is a pipe, which two files cannot go
  /// to, and where there is no name to call them by.
  SkyFiles files(const std::string& input) const;
};

/// Adds --gamut, which says what becomes of colours outside Rec.709, to a subcommand.
void addGamut(CLI::App& command, std::string& gamut);

/// What --gamut says.
Gamut gamutOf(const std::string& gamut);

/// Says on stderr what was written, and what the reconstruction remarked.
void reportPicture(const SkyFiles& files, const WrittenSky& written, const std::vector<std::string>& remarks);

}  // namespace parhelion::cli
