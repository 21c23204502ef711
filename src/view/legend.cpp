// SPDX-License-Identifier: Apache-2.0
#include "view/legend.h"

#include <algorithm>

namespace parhelion {
namespace {

// Shares of the picture's sides that a legend may take.
constexpr double kMostWidth = 0.4, kMostHeight = 0.4;

// Lengths in sizes of the letters.
constexpr double kRow = 1.35;
constexpr double kSwatch = 1.5;     // of line
constexpr double kMargin = 0.6;     // to the picture's border, and inside
constexpr double kSwatchGap = 0.5;  // to the text
constexpr double kLine = 0.16;

Vec2 sizeOf(const Labels& labels, const std::vector<HaloFamily>& families) {
  double width = 0.0;
  for (const HaloFamily family : families)
    width = std::max(width, labels.around(legendText(family), Vec2(0.0)).size().x);
  const double rows = static_cast<double>(families.size());
  return Vec2(width, 0.0) +
         labels.size() * Vec2(kSwatch + kSwatchGap + 2.0 * kMargin, kRow * rows + 2.0 * kMargin - 0.3);
}

/// The corner with least in it, lower ones first.
Box emptiestCorner(const Vec2& size, double margin, const Camera& camera, const Crowd& crowd) {
  const Vec2 far = Vec2(camera.width(), camera.height()) - size - Vec2(margin);
  std::vector<Box> corners;
  for (const Vec2& at : {Vec2(margin, far.y), far, Vec2(far.x, margin), Vec2(margin)})
    corners.push_back({at, at + size});
  return *std::min_element(corners.begin(), corners.end(),
                           [&](const Box& a, const Box& b) { return crowd.in(a) < crowd.in(b); });
}

}  // namespace

void drawLegend(Canvas& canvas, Labels& labels, const Crowd& crowd, const Camera& camera,
                const std::vector<HaloFamily>& families, const Palette& palette) {
  if (families.empty()) return;
  const double em = labels.size();
  const Vec2 size = sizeOf(labels, families);
  if (size.x > kMostWidth * camera.width() || size.y > kMostHeight * camera.height()) return;
  const Box box = emptiestCorner(size, 0.5 * kMargin * em, camera, crowd);
  Colour ground = palette.textShadow;
  ground.alpha = 0.5;
  canvas.rectangle(box, ground);
  Vec2 row = box.min + em * Vec2(kMargin);
  for (const HaloFamily family : families) {
    Colour colour = palette.of(family);
    colour.alpha = 1.0;
    const Vec2 middle = row + em * Vec2(0.0, 0.5 * kRow - 0.1);
    canvas.lines({{middle, middle + em * Vec2(kSwatch, 0.0)}}, {colour, kLine * em});
    canvas.text(legendText(family), row + em * Vec2(kSwatch + kSwatchGap, 0.0), em, colour, palette.textShadow);
    row.y += kRow * em;
  }
  labels.keepOff(box);
}

}  // namespace parhelion
