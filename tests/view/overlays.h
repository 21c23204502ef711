// SPDX-License-Identifier: Apache-2.0
#pragma once

// Overlays for tests, and what is drawn in them.

#include <algorithm>
#include <string>

#include "sky/look_at.h"
#include "view/overlay.h"

namespace parhelion {

inline constexpr double kIndex = 1.311;

/// Nothing but what a test adds.
inline OverlaySettings bare() {
  OverlaySettings s;
  s.gridStep = 0.0;
  s.horizon = s.zenith = s.labels = false;
  return s;
}

inline OverlaySettings everything() {
  OverlaySettings s;
  s.circles = {radians(10), radians(30)};
  s.halos = true;
  return s;
}

inline CameraSettings cameraOf(Projection projection, double azimuth, double elevation, double fieldOfView, int width,
                               int height) {
  return test::lookAt(projection, azimuth, elevation, 0.0, fieldOfView, width, height);
}

inline CameraSettings wholeSky(int size) { return cameraOf(Projection::fisheyeEqualArea, 0, 90, 180, size, size); }

inline int alphaAt(const LineArt& layer, int x, int y) {
  return layer
      .rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(layer.width) + static_cast<std::size_t>(x)) +
            3];
}

/// Calls `look` with the middle and the alpha of each pixel that has been drawn on.
template <class Look>
void forEachDrawn(const LineArt& layer, Look&& look) {
  for (int y = 0; y < layer.height; ++y)
    for (int x = 0; x < layer.width; ++x)
      if (const int alpha = alphaAt(layer, x, y)) look(Vec2(x + 0.5, y + 0.5), alpha);
}

inline int drawnPixels(const LineArt& layer) {
  int count = 0;
  forEachDrawn(layer, [&](const Vec2&, int) { ++count; });
  return count;
}

inline bool hasLabel(const Overlay& o, const std::string& text) {
  return std::any_of(o.labels.begin(), o.labels.end(), [&](const PlacedLabel& l) { return l.text == text; });
}

}  // namespace parhelion
