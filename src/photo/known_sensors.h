// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "picture/exif.h"

namespace parhelion {

/// The light-sensitive part of a camera, mm: its longer and its shorter side.
struct Sensor {
  double width, height;
};

/// The sensor of a camera with interchangeable lenses, and of a few others with sensors as large, by the name of its
/// model; none for all others. Sides as the makers state them; those of one family differ by up to two percent.
std::optional<Sensor> knownSensor(const Exif& exif);

/// Whether a sensor of that width is one that many cameras have: full frame, APS-C, Four Thirds, one inch, or the small
/// ones of phones and compact cameras.
bool isCommonSensor(double width);

/// Widest of the small sensors, mm.
inline constexpr double kSmallSensor = 8.0;

/// By how much sensors of one kind, and their sizes as resolutions tell them, differ.
inline constexpr double kSensorSlack = 0.04;

}  // namespace parhelion
