// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "math/conventions.h"
#include "optics/sky_line.h"
#include "view/labels.h"

namespace parhelion {

/// A line of a grid and what it says.
struct GridLine {
  SkyLine line;
  double angle;     // rad: its altitude or its azimuth
  int number;       // of steps in it
  bool isAltitude;  // else a meridian
  bool isBelow;     // the horizon
};

/// Lines of equal altitude, the horizon left out, and of equal azimuth, `step` (rad) apart, from the horizon and from
/// the sun's azimuth on. Only every 90 degrees does a meridian go through to the zenith.
std::vector<GridLine> gridLines(double step);

/// Degrees with a degree sign and a true minus, "22.5°"; of azimuths 1 to 179 with a plus, to the sun's right.
std::string degreeText(double angle, bool plus);

/// Labels have room on every so many lines.
int labelEvery(const Camera& camera, const Labels& labels, double step);

/// Rectangles for the label of a grid line, best first: for azimuths on the horizon; where that is not to be seen and
/// for altitudes where the line meets the picture's border; for altitudes that meet none beside a meridian. `lines` is
/// what the picture shows of the line.
std::vector<Box> gridLabelPlaces(const Camera& camera, const Labels& labels, const GridLine& line,
                                 const std::vector<PixelLine>& lines, double step);

}  // namespace parhelion
