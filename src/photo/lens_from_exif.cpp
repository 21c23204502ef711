// SPDX-License-Identifier: Apache-2.0
#include "photo/lens_from_exif.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "math/portable.h"
#include "sky/camera.h"

namespace parhelion {
namespace {

constexpr double kFilmDiagonal = 43.266615305567875;  // mm, of 36 mm x 24 mm

// mm. Phones have focal lengths from 1.5 mm, telescopes to a few metres; circular fisheyes equivalents from 4 mm.
struct Range {
  double least, most;
};
constexpr Range kFocalLengths{0.5, 5000.0};
constexpr Range kEquivalents{4.0, 5000.0};

// Picture diagonals: from wider than any fisheye to a field of view of a tenth of a degree.
constexpr Range kFocalDiagonals{0.05, 500.0};

// Beyond this ratio two focal lengths differ by more than rounding to whole millimetres and the maker's freedom.
constexpr double kAgreement = 1.2;

// Sides of a scaled picture are rounded to a pixel, by some programs to multiples of eight.
constexpr double kSlackPixels = 1.0;
constexpr double kSlackShare = 0.01;

// Relative. Field of view at the very limit of a projection: lost digits must not count as beyond it.
constexpr double kRounding = 1e-15;

std::string text(double number) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.6g", number);
  return digits;
}

bool isWithin(const Range& range, double value) { return value >= range.least && value <= range.most; }

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument("Exif " + what); }

double diagonal(double width, double height) { return std::sqrt(width * width + height * height); }

/// Pixels now for each pixel of the picture that left the camera. Only the longer and shorter sides are compared: the
/// picture may have been turned upright.
double scaleSinceExposure(const Exif& exif, int width, int height) {
  if (exif.pixelWidth.value_or(0) <= 0 || exif.pixelHeight.value_or(0) <= 0) return 1.0;
  const auto [exifShort, exifLong] = std::minmax({*exif.pixelWidth, *exif.pixelHeight});
  const auto [nowShort, nowLong] = std::minmax({width, height});
  const double scale = static_cast<double>(nowLong) / exifLong;
  const double expected = scale * exifShort;
  if (std::abs(nowShort - expected) > kSlackPixels + kSlackShare * expected)
    refuse("tells of " + std::to_string(*exif.pixelWidth) + " x " + std::to_string(*exif.pixelHeight) +
           " pixels, the picture has " + std::to_string(width) + " x " + std::to_string(height) +
           ": it has been cropped, and its field of view is not Exif's");
  return scale;
}

/// Pixels of the picture that left the camera in a millimetre of its sensor; none where Exif does not say.
std::optional<double> pixelsPerMillimetre(const Exif& exif) {
  const std::optional<double> resolution = exif.focalPlaneX ? exif.focalPlaneX : exif.focalPlaneY;
  if (!resolution) return std::nullopt;
  if (exif.focalPlaneUnit == 2) return *resolution / 25.4;
  if (exif.focalPlaneUnit == 3) return *resolution / 10.0;
  return std::nullopt;
}

/// Half the field of view along an extent, from its half in focal lengths; none where the projection ends before.
std::optional<double> angleAt(Projection projection, double radius) {
  const auto arcsine = [](double sine) -> std::optional<double> {
    if (sine > 1.0 + kRounding) return std::nullopt;
    return portable::atan2(sine, std::sqrt(std::max(0.0, (1.0 - sine) * (1.0 + sine))));
  };
  switch (projection) {
    case Projection::rectilinear:
      return portable::atan2(radius, 1.0);
    case Projection::fisheyeStereographic:
      return 2.0 * portable::atan2(0.5 * radius, 1.0);
    case Projection::fisheyeOrthographic:
      return arcsine(radius);
    case Projection::fisheyeEqualArea: {
      const std::optional<double> half = arcsine(0.5 * radius);
      return half ? std::optional(2.0 * *half) : std::nullopt;
    }
    case Projection::fisheyeEquidistant:
    case Projection::equirectangular:
      break;
  }
  return radius <= kPi * (1.0 + kRounding) ? std::optional(radius) : std::nullopt;
}

}  // namespace

std::optional<LensFacts> lensFromExif(const Exif& exif, int width, int height) {
  if (exif.focalLength35mm && !isWithin(kEquivalents, *exif.focalLength35mm))
    refuse("has a 35 mm equivalent of " + text(*exif.focalLength35mm) + " mm, which no lens has");
  if (exif.focalLength && !isWithin(kFocalLengths, *exif.focalLength))
    refuse("has a focal length of " + text(*exif.focalLength) + " mm, which no lens has");

  const double pictureDiagonal = diagonal(width, height);
  std::optional<LensFacts> film, sensor;
  if (exif.focalLength35mm)
    film = {*exif.focalLength35mm * pictureDiagonal / kFilmDiagonal,
            "35 mm equivalent " + text(*exif.focalLength35mm) + " mm"};
  if (const auto resolution = pixelsPerMillimetre(exif); resolution && exif.focalLength)
    sensor = {*exif.focalLength * *resolution,
              "focal length " + text(*exif.focalLength) + " mm at " + text(*resolution) + " pixels/mm"};
  if (!film && !sensor) return std::nullopt;

  // A picture that has been cropped is refused whichever it would be.
  const double scale = scaleSinceExposure(exif, width, height);
  if (sensor) sensor->focalPixels *= scale;
  if (!film) {
    if (!isWithin(kFocalDiagonals, sensor->focalPixels / pictureDiagonal))
      refuse("has a " + sensor->source + ", which no lens and sensor have");
    return sensor;
  }
  if (!sensor) return film;
  const double ratio = sensor->focalPixels / film->focalPixels;
  if (ratio <= kAgreement && ratio * kAgreement >= 1.0) return sensor;
  film->source += " (its " + sensor->source + " says " + text(ratio) + " times that)";
  return film;
}

CameraSettings withFocalLength(CameraSettings settings, double focalPixels) {
  if (!(focalPixels > 0.0 && std::isfinite(focalPixels)))
    throw std::invalid_argument("a focal length of " + text(focalPixels) + " pixels is none");
  const auto [width, height] = std::pair<double, double>(settings.width, settings.height);
  struct Extent {
    FieldOfViewAxis axis;
    double pixels;
  };
  const Extent horizontal{FieldOfViewAxis::horizontal, width}, vertical{FieldOfViewAxis::vertical, height};
  const bool isWide = width >= height;
  for (const Extent& extent : {Extent{FieldOfViewAxis::diagonal, diagonal(width, height)},
                               isWide ? horizontal : vertical, isWide ? vertical : horizontal}) {
    const std::optional<double> angle = angleAt(settings.projection, 0.5 * extent.pixels / focalPixels);
    if (!angle) continue;
    settings.fieldOfViewAxis = extent.axis;
    settings.fieldOfView = 2.0 * *angle;
    return settings;
  }
  throw std::invalid_argument("a " + std::string(name(settings.projection)) + " lens with a focal length of " +
                              text(focalPixels) + " pixels does not fill the picture along either side");
}

}  // namespace parhelion
