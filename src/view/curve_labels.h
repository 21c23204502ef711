// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "view/labels.h"

namespace parhelion {

/// A line of the picture that is to be named.
struct NamedCurve {
  std::string text;
  std::vector<PixelLine> lines;
  std::optional<Vec2> preferred;  // where its name would best be
  Colour colour;
};

/// A spot of the picture that is to be named.
struct NamedSpot {
  std::string text;
  Vec2 at;
  double radius;  // pixels
  Colour colour;
};

/// Places for the name of a curve, best first: beside it and, with leaders, farther off, where few lines are. `crowd`
/// has all lines of the picture.
std::vector<LabelPlace> placesFor(const NamedCurve& curve, const Crowd& crowd, const Labels& labels,
                                  const Camera& camera);

/// The same for a spot.
std::vector<LabelPlace> placesFor(const NamedSpot& spot, const Crowd& crowd, const Labels& labels);

}  // namespace parhelion
