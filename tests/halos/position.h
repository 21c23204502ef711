// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace parhelion {

/// A measured position (degrees) against the closed form, to within `tolerance`. scripts/docs collects the printed rows
/// for docs/accuracy.md.
inline void checkPosition(const std::string& what, double expected, double measured, double tolerance) {
  char row[200];
  std::snprintf(row, sizeof row, "position: | %s | %.3f | %.3f | %+.3f |", what.c_str(), expected, measured,
                measured - expected);
  MESSAGE(row);
  CHECK(std::abs(measured - expected) < tolerance);
}

/// ", sun 20°"
inline std::string atSun(double sunDegrees) { return ", sun " + std::to_string(static_cast<int>(sunDegrees)) + "°"; }

}  // namespace parhelion
