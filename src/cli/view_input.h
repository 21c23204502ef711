// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/photo_options.h"
#include "picture/auto_exposure.h"
#include "picture/photograph.h"
#include "sky/tally.h"
#include "view/display.h"

namespace parhelion::cli {

/// A picture of any kind that can be viewed.
struct ViewInput {
  std::string path;
  Photograph photograph;       // of an EXR only size and text, without samples
  std::optional<Image> light;  // of an EXR: what it holds; of a tally: each pixel's own light, unfiltered
  Image layers;                // of an EXR whose layers are to be named: their light
  std::optional<Tally> tally;
  bool hasRings = false;  // of a tally: some light counts for whole rings about the sun

  std::string sceneFile;  // the file that has the scene

  /// The scene of the picture.
  std::optional<std::string> scene() const;

  /// Whether the picture is a photograph, with or without a halo in it.
  bool isPhotograph() const;
};

/// Reads a photograph, a sky or a tally, told apart by what is in the file. Throws std::runtime_error "path: reason".
/// Of an EXR with layers of light it shows only those of `layers`, or all if there are none there. Throws Unfit where
/// it has no such layer. `withNames`: whether layers get their names (view_layers.h), for which their light is kept.
ViewInput readViewInput(const std::string& path, const PhotographRules& rules,
                        const std::vector<std::string>& layers = {}, bool withNames = false);

/// Gives a picture without a scene, such as a preview whose text has been lost, that of the sky of the same name and
/// shape beside it, if there is one: an EXR of render or recon.
void takeSceneBeside(ViewInput& input);

struct Shown {
  Display display;
  std::optional<double> exposure;  // stops, of linear light
};

/// The picture as a screen shows it: photographs of 8 and 16 bits as they are, linear light developed. Without an
/// exposure it gets that which suits it. Throws CLI::ValidationError for an exposure value where the picture does not
/// say which luminance its white is.
Shown show(const ViewInput& input, const LightDisplay& how);

/// Linear light, Rec.709: that of a photograph is 1 at white.
Image lightOf(ViewInput input);

/// The first channel of a picture of width x height pixels, which says what of another is sky: 0 nothing, 255 all.
/// Throws std::runtime_error "path: reason", also if it has another size.
std::vector<std::uint8_t> readMaskFor(const std::string& path, int width, int height);

}  // namespace parhelion::cli
