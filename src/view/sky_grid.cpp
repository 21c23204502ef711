// SPDX-License-Identifier: Apache-2.0
#include "view/sky_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>

#include <glm/geometric.hpp>

#include "math/rotation.h"

namespace parhelion {
namespace {

// Multiples of a step count as reaching an angle in spite of rounding, rad.
constexpr double kAngleSlack = 1e-9;

// Altitudes that meet no border are labelled half a step beside one of these azimuths, rad.
constexpr double kLabelAzimuths[] = {-kPi, 0.5 * kPi, -0.5 * kPi, 0.0};

// Distances of azimuth labels from the horizon, in sizes of the letters, best first: a curved one needs more.
constexpr double kAboveHorizon[] = {0.4, 0.6, 0.8, 1.0, 1.3, 1.6};

// Every so many lines have labels: steps of 5 and 10 degrees then have them at multiples of 15, 30 and 90 too.
constexpr int kLabelEvery[] = {1, 2, 3, 6, 9, 18};

constexpr double kJustAbove = 1e-6;  // rad; far below a pixel

SkyLine meridian(double azimuth, double from, double to) {
  const auto lines = followLocus(from, to, [azimuth](double altitude) { return skyDirection(azimuth, altitude); });
  return lines.front();
}

bool isMultiple(double angle, double of) { return std::abs(std::remainder(angle, of)) < kAngleSlack; }

/// The label of an azimuth just above the horizon, whatever way that is in the picture.
std::vector<Box> onHorizon(const Camera& camera, const Labels& labels, const std::string& text, double azimuth) {
  // Not on the horizon itself, which may be the rim of two discs.
  const std::optional<Vec2> foot = camera.placeOf(skyDirection(azimuth, kJustAbove));
  const std::optional<Vec2> above = camera.placeOf(skyDirection(azimuth, radians(0.5)));
  if (!foot || !above || *foot == *above) return {};
  const Vec2 up = glm::normalize(*above - *foot), size = labels.around(text, Vec2(0.0)).size();
  const double reach = 0.5 * (std::abs(up.x) * size.x + std::abs(up.y) * size.y);
  std::vector<Box> boxes;
  for (const double distance : kAboveHorizon)
    boxes.push_back(labels.around(text, *foot + (reach + distance * labels.size()) * up));
  return boxes;
}

/// The label's place on a line as near as can be to one end of it.
void addNearEnd(std::vector<Box>& boxes, const Labels& labels, const std::string& text, const PixelLine& line,
                bool atBack) {
  const double reach = 2.0 * glm::length(labels.around(text, Vec2(0.0)).size());
  const Vec2 end = atBack ? line.back() : line.front();
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2 at = atBack ? line[line.size() - 1 - i] : line[i];
    if (glm::length(at - end) > reach) return;
    const Box box = labels.around(text, at);
    if (labels.fits(box)) {
      boxes.push_back(box);
      return;
    }
  }
}

}  // namespace

std::vector<GridLine> gridLines(double step) {
  std::vector<GridLine> grid;
  const Vec3 zenith(0.0, 0.0, 1.0);
  const double right = 0.5 * kPi;
  const int altitudes = static_cast<int>(std::ceil((right - kAngleSlack) / step)) - 1;
  for (int i = -altitudes; i <= altitudes; ++i)
    if (i != 0) grid.push_back({circleAbout(zenith, right - i * step), i * step, i, true, i < 0});

  const double highest = std::max(altitudes * step, 0.5 * right);
  const int azimuths = static_cast<int>(std::ceil((kPi - kAngleSlack) / step));
  for (int i = -azimuths + 1; i <= azimuths; ++i) {
    // A step that does not divide the circle leaves a narrower gap at the antisolar azimuth.
    const double azimuth = std::min(i * step, kPi);
    const double top = isMultiple(azimuth, right) ? right : highest;
    grid.push_back({meridian(azimuth, 0.0, top), azimuth, i, false, false});
    grid.push_back({meridian(azimuth, 0.0, -top), azimuth, i, false, true});
  }
  return grid;
}

std::string degreeText(double angle, bool plus) {
  const double value = std::round(degrees(std::abs(angle)) * 100.0) / 100.0;
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.6g", value);
  const bool hasSide = value > 0.0 && value < 180.0;
  const char* sign = angle < 0.0 && value > 0.0 ? "−" : plus && hasSide ? "+" : "";
  return std::string(sign) + digits + "°";
}

int labelEvery(const Camera& camera, const Labels& labels, double step) {
  const double room = 1.5 * labels.around("+100°", Vec2(0.0)).size().x;
  for (const int every : kLabelEvery)
    if (every * step * camera.focalLength() > room) return every;
  return kLabelEvery[std::size(kLabelEvery) - 1];
}

std::vector<Box> gridLabelPlaces(const Camera& camera, const Labels& labels, const GridLine& line,
                                 const std::vector<PixelLine>& lines, double step) {
  const std::string text = degreeText(line.angle, !line.isAltitude);
  if (!line.isAltitude && camera.project(skyDirection(line.angle, kJustAbove)))
    return onHorizon(camera, labels, text, line.angle);
  std::vector<Box> places;
  for (const PixelLine& piece : lines)
    if (piece.front() != piece.back())
      for (const bool atBack : {false, true}) addNearEnd(places, labels, text, piece, atBack);
  // The left border for altitudes, the lower one for azimuths.
  std::stable_sort(places.begin(), places.end(),
                   [&](const Box& a, const Box& b) { return line.isAltitude ? a.min.x < b.min.x : a.max.y > b.max.y; });
  if (line.isAltitude)
    for (const double azimuth : kLabelAzimuths)
      if (const auto at = camera.placeOf(skyDirection(azimuth + 0.5 * step, line.angle)))
        places.push_back(labels.around(text, *at));
  return places;
}

}  // namespace parhelion
