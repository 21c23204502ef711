// SPDX-License-Identifier: Apache-2.0
#include "view/curve_labels.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace parhelion {
namespace {

// Lengths in sizes of the letters.
constexpr double kGaps[] = {0.45, 1.5, 3.0};  // between a label and what it names
constexpr double kBeside = 0.7;               // a curve that near a label seems to be meant by it

// Names look for places along this many points of their curve.
constexpr std::size_t kTries = 96;

// A label moves by this share of the picture's shorter side to keep off one line, and takes a leader one step longer
// to keep off so many lines.
constexpr double kWorthOfLine = 0.4;
constexpr double kCostOfGap = 0.7;

struct Candidate {
  double cost;
  LabelPlace place;
};

std::vector<LabelPlace> cheapestFirst(std::vector<Candidate> candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  std::vector<LabelPlace> places;
  for (const Candidate& candidate : candidates) places.push_back(candidate.place);
  return places;
}

/// Fewest lines under the label, other curves not beside it either.
double linesAt(const Box& box, const Crowd& crowd, const Crowd& own, double em) {
  const Box wide = box.grownBy(kBeside * em);
  return (crowd.in(wide)-own.in(wide) + own.in(box)) / box.size().y;
}

}  // namespace

std::vector<LabelPlace> placesFor(const NamedCurve& curve, const Crowd& crowd, const Labels& labels,
                                  const Camera& camera) {
  const double em = labels.size(), side = std::min(camera.width(), camera.height());
  Crowd own(camera.width(), camera.height(), 0.5 * em);
  own.add(curve.lines, 1.0);
  std::size_t points = 0;
  for (const PixelLine& line : curve.lines) points += line.size();
  const std::size_t stride = points / kTries + 1;
  std::vector<Candidate> candidates;
  const auto consider = [&](const Vec2& anchor) {
    const double off = curve.preferred ? glm::length(anchor - *curve.preferred) / (kWorthOfLine * side) : 0.0;
    double farther = 0.0;
    for (const double gap : kGaps) {
      for (const Box& box : labels.beside(curve.text, anchor, gap * em))
        candidates.push_back({linesAt(box, crowd, own, em) + off + farther, {box, anchor}});
      farther += kCostOfGap;
    }
  };
  for (const PixelLine& line : curve.lines)
    for (std::size_t i = line.size() > stride ? stride / 2 : 0; i < line.size(); i += stride) consider(line[i]);
  return cheapestFirst(std::move(candidates));
}

std::vector<LabelPlace> placesFor(const NamedSpot& spot, const Crowd& crowd, const Labels& labels) {
  const Box mark{spot.at - Vec2(spot.radius), spot.at + Vec2(spot.radius)};
  std::vector<Candidate> candidates;
  double farther = 0.0;
  for (const double gap : kGaps) {
    for (const Box& box : labels.beside(spot.text, spot.at, spot.radius + gap * labels.size())) {
      const Vec2 middle = 0.5 * (box.min + box.max);
      candidates.push_back({crowd.in(box) / box.size().y + farther, {box, glm::clamp(middle, mark.min, mark.max)}});
    }
    farther += kCostOfGap;
  }
  return cheapestFirst(std::move(candidates));
}

}  // namespace parhelion
