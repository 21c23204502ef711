// SPDX-License-Identifier: Apache-2.0
#pragma once

// What commands make of a picture that they have read.

#include <stdexcept>

#include "photo/photo_camera.h"
#include "photo/sky_mask.h"
#include "picture/auto_exposure.h"
#include "picture/photograph.h"
#include "view/display.h"

namespace parhelion {

// The sanitizers make the work on a pixel take a microsecond. A few bytes may hold many pixels.
inline constexpr std::size_t kMostDeveloped = 1 << 16;

/// As `view` shows a sky.
inline void useLight(const Image& image) {
  if (image.pixels() > kMostDeveloped || !image.find("R") || !image.find("G") || !image.find("B")) return;
  quantised(developed(image, {autoExposure(image)}));
}

/// The lens that a photograph was taken with.
inline void useLens(const Photograph& photograph) {
  try {
    if (const auto lens = findLens(photograph, {})) pointLens(lens->camera, {});
  } catch (const std::invalid_argument&) {  // what Exif says cannot be
  }
}

/// As `composite` and `view` take a photograph: for a mask, and for what it shows.
inline void usePhotograph(const Photograph& photograph) {
  useLens(photograph);
  if (photograph.pixels() > kMostDeveloped) return;
  skyMaskOf(photograph);
  const bool isLight = std::holds_alternative<std::vector<float>>(photograph.samples);
  if (!isLight) quantised(shown(photograph));
  useLight(linearImage(photograph, isLight ? 1 : 3));
}

}  // namespace parhelion
