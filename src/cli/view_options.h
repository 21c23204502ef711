// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/photo_options.h"
#include "cli/picture.h"
#include "view/overlay.h"
#include "view/sky_profile.h"
#include "view/unsharp.h"

namespace parhelion::cli {

/// What a user says on the command line of `view`.
struct ViewOptions {
  std::string input, output, layer, mask;
  std::vector<std::string> beside;  // pictures to the right
  std::string minus;                // the other picture
  std::vector<std::string> layers;  // of light; empty: all
  std::string unsharp;              // AMOUNT,RADIUS
  bool redMinusBlue = false, dots = false;
  std::optional<int> dotSize;  // pixels
  int reduction = 1;           // pixels averaged in each direction
  std::optional<double> gain;
  DisplayWords display;
  std::string glare;  // "eye", "lens" or "none"; empty: none
  std::optional<int> blades;
  std::optional<double> aperture;  // mm
  int bits = 8;                    // of a component
  PhotoOptions photo;
  bool quiet = false, overwrite = false;

  // Lines over the picture; angles in degrees.
  bool overlay = false, horizonLine = false, zenith = false, halos = false, labels = false;
  std::optional<double> grid;
  std::string circles;
  std::string crystals, scene;       // whose halos are drawn, instead of those in the picture's scene: names, or a file
  std::optional<bool> belowHorizon;  // whether lines are drawn there; left out: over simulations, not photographs

  // The profile; angles in degrees.
  std::string profile, chart;
  std::optional<double> from, to, bin;

  void addTo(CLI::App& command);

  /// Throws CLI::ValidationError for options that have no meaning together.
  void requireSense() const;

  bool drawsLines() const;
  bool drawsHalos() const { return overlay || halos; }

  /// The families that --crystals names.
  std::vector<HaloFamily> families() const;

  bool addsGlare() const { return glare == "eye" || glare == "lens"; }
  bool needsCamera() const { return drawsLines() || !profile.empty(); }
  OverlaySettings overlaySettings() const;
  UnsharpSettings unsharpSettings() const;
  SkyProfileSettings profileSettings() const;
};

}  // namespace parhelion::cli
