// SPDX-License-Identifier: Apache-2.0
#include "photo/lens_from_exif.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "math/range.h"
#include "math/rotation.h"
#include "photo/known_sensors.h"
#include "sky/projections.h"

namespace parhelion {
namespace {

constexpr double kFilmDiagonal = 43.266615305567875;  // mm, of 36 mm x 24 mm

// mm. Phones have focal lengths from 1.5 mm, telescopes to a few metres; circular fisheyes equivalents from 4 mm.
constexpr Range kFocalLengths{0.5, 5000.0};
constexpr Range kEquivalents{4.0, 5000.0};

// Beyond this ratio two focal lengths differ by more than rounding to whole millimetres and the maker's freedom.
constexpr double kAgreement = 1.2;

// Sides of a scaled picture are rounded to a pixel, by some programs to multiples of eight.
constexpr double kSlackPixels = 1.0;
constexpr double kSlackShare = 0.01;

// Less is what some phones enlarge after straightening a picture. 0 says that there was none.
constexpr Range kDigitalZooms{1.05, 100.0};

// Larger sensors have had as many pixels a millimetre, and hardly any lens for them is shorter.
constexpr Range kPixelsOfLargeSensors{80.0, 420.0};
constexpr double kShortestForLargeSensors = 8.0;  // mm

std::string text(double number, const char* format = "%.6g") {
  char digits[32];
  std::snprintf(digits, sizeof digits, format, number);
  return digits;
}

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument("Exif " + what); }

double diagonal(double width, double height) { return std::sqrt(width * width + height * height); }

/// The longer and the shorter side of a picture or sensor. They stay when it is turned.
struct Sides {
  double longer, shorter;

  Sides(double a, double b) : longer(std::max(a, b)), shorter(std::min(a, b)) {}
  Sides scaled(double scale) const { return {scale * longer, scale * shorter}; }
  double diagonal() const { return parhelion::diagonal(longer, shorter); }

  /// Whether a picture shows the whole of this one, larger or smaller.
  bool isWholeIn(const Sides& picture) const {
    const double expected = picture.longer / longer * shorter;
    return std::abs(picture.shorter - expected) <= kSlackPixels + kSlackShare * expected;
  }
};

/// A picture now, and what its Exif tells of its lens.
struct Told {
  const Exif& exif;
  int width, height;             // pixels
  std::optional<double> focal;   // mm
  std::optional<double> film;    // mm, on 35 mm film
  std::optional<double> perMm;   // pixels of the picture that left the camera in a millimetre of its sensor
  std::optional<Sensor> sensor;  // of a known model
  std::optional<double> zoom;    // digital; none where there was none

  Sides picture() const { return Sides(width, height); }
};

/// A positive number; 0 is how cameras write that they do not know it.
std::optional<double> known(std::optional<double> mm, const Range& possible, const std::string& name) {
  if (!mm || *mm == 0.0) return std::nullopt;
  if (!possible.contains(*mm)) refuse("has a " + name + " of " + text(*mm) + " mm, which no lens has");
  return mm;
}

std::optional<double> pixelsPerMillimetre(const Exif& exif) {
  const auto isSane = [](std::optional<double> r) { return r && *r > 0.0 && std::isfinite(*r); };
  const std::optional<double> resolution = isSane(exif.focalPlaneX) ? exif.focalPlaneX : exif.focalPlaneY;
  if (!isSane(resolution)) return std::nullopt;
  switch (exif.focalPlaneUnit) {
    case 2:
      return *resolution / 25.4;
    case 3:
      return *resolution / 10.0;
    case 4:
      return *resolution;
    case 5:
      return *resolution * 1e3;
    default:
      return std::nullopt;
  }
}

Told read(const Exif& exif, int width, int height) {
  Told told{exif, width, height, {}, {}, pixelsPerMillimetre(exif), knownSensor(exif), {}};
  told.film = known(exif.focalLength35mm, kEquivalents, "35 mm equivalent");
  told.focal = known(exif.focalLength, kFocalLengths, "focal length");
  if (exif.digitalZoom && kDigitalZooms.contains(*exif.digitalZoom)) told.zoom = exif.digitalZoom;
  return told;
}

/// The size that Exif gives for the picture. Without its height it is taken for uncropped.
std::optional<Sides> sizeInExif(const Told& told) {
  const double exifWidth = told.exif.pixelWidth.value_or(0), exifHeight = told.exif.pixelHeight.value_or(0);
  if (exifWidth <= 0.0) return std::nullopt;
  if (exifHeight > 0.0) return Sides(exifWidth, exifHeight);
  const bool turned = told.exif.orientation >= 5;
  return told.picture().scaled(exifWidth / (turned ? told.height : told.width));
}

/// Refuses a picture that shows only a part of a `whole` of these sides. `focal` is the lens's focal length in the
/// same unit, if known.
[[noreturn]] void refuseCropped(const Told& told, const std::string& whole, const Sides& sides,
                                std::optional<double> focal) {
  std::string words = "tells of " + whole + ", the picture has " + std::to_string(told.width) + " x " +
                      std::to_string(told.height) + " pixels: it has been cropped, and its field of view is not Exif's";
  if (focal) {
    const Sides picture = told.picture();
    const double pixels = *focal * std::max(picture.longer / sides.longer, picture.shorter / sides.shorter);
    words += "; if no more was cut off than its shape asks, it is " +
             text(equivalentOnFilm(pixels, told.width, told.height), "%.3g") + " mm on 35 mm film, " +
             text(degrees(2.0 * std::atan2(0.5 * told.width, pixels)), "%.1f") +
             " degrees from left to right unless a fisheye's";
  }
  refuse(words);
}

/// Throws if the picture is not the whole of what the camera took. What the camera itself noted counts first: there are
/// files in which Exif's size is that of the thumbnail.
void requireWhole(const Told& told) {
  std::vector<Sides> sizes;
  for (const PictureSize& size : told.exif.sizesTaken) sizes.emplace_back(size.width, size.height);
  if (const auto size = sizeInExif(told); size && sizes.empty()) sizes.push_back(*size);
  for (const Sides& size : sizes) {
    if (size.isWholeIn(told.picture())) continue;
    std::optional<double> focal;
    if (told.film)
      focal = *told.film * size.diagonal() / kFilmDiagonal;
    else if (told.focal && told.sensor)
      focal = *told.focal * size.longer / told.sensor->width;
    else if (told.focal && told.perMm)
      focal = *told.focal * *told.perMm;
    refuseCropped(told, text(size.longer) + " x " + text(size.shorter) + " pixels", size, focal);
  }
}

/// Whether an area is all of a sensor, or what a camera with a choice of shapes uses of it.
bool isUsed(const Sides& area, const Sensor& sensor) {
  const double across = area.longer / sensor.width, down = area.shorter / sensor.height;
  return std::abs(std::max(across, down) - 1.0) <= kSensorSlack;
}

/// Whether the picture of a larger sensor may have been scaled so that the numbers are those of a small one.
bool mayBeLarger(const Told& told, const Sides& area) {
  return area.longer < kSmallSensor * (1.0 + kSensorSlack) && kPixelsOfLargeSensors.contains(*told.perMm) &&
         *told.focal >= kShortestForLargeSensors;
}

/// From focal length and sensor resolution. The resolution is that of the picture that left the camera: its size is the
/// first of those told that makes a sensor which there is. None where no size does.
std::optional<LensFacts> lensByResolution(const Told& told) {
  if (!told.focal || !told.perMm) return std::nullopt;
  const Sides now = told.picture();
  const auto lensOf = [&](const Sides& taken, bool isSure) -> std::optional<LensFacts> {
    const Sides area = taken.scaled(1.0 / *told.perMm);
    const bool there =
        told.sensor ? isUsed(area, *told.sensor) : isCommonSensor(area.longer) && (isSure || !mayBeLarger(told, area));
    if (!there) return std::nullopt;
    std::string source = "focal length " + text(*told.focal) + " mm at " + text(*told.perMm) + " pixels/mm";
    if (taken.longer != now.longer)
      source += " of " + text(taken.longer, "%.0f") + " x " + text(taken.shorter, "%.0f") + " pixels before scaling";
    return LensFacts{*told.focal * *told.perMm * now.longer / taken.longer, source};
  };
  for (const PictureSize& size : told.exif.sizesTaken)
    if (const auto lens = lensOf(Sides(size.width, size.height), true)) return lens;
  if (const auto size = sizeInExif(told))
    if (const auto lens = lensOf(*size, false)) return lens;
  return lensOf(now, false);
}

/// From focal length and the sensor of a known model.
std::optional<LensFacts> lensByModel(const Told& told) {
  if (!told.focal || !told.sensor) return std::nullopt;
  const Sides sensor(told.sensor->width, told.sensor->height);
  const std::string words =
      "the " + told.exif.model + " and its sensor of " + text(sensor.longer) + " x " + text(sensor.shorter) + " mm";
  if (!sensor.isWholeIn(told.picture())) refuseCropped(told, words, sensor, told.focal);
  return LensFacts{*told.focal * told.picture().longer / sensor.longer,
                   "focal length " + text(*told.focal) + " mm of " + words};
}

/// Throws where there is a resolution that fits no sensor.
void refuseSensor(const Told& told) {
  if (!told.focal || !told.perMm) return;
  const double width = told.picture().longer / *told.perMm;
  refuse("has a focal length of " + text(*told.focal) + " mm at " + text(*told.perMm) +
         " pixels/mm, and so the picture a sensor of " + text(width, "%.3g") + " mm" +
         (isCommonSensor(width) ? ", but it may be of a larger sensor and made smaller since"
                                : ", which no common camera has: it was made smaller or larger since, or cropped"));
}

/// Half the field of view along an extent, from its half in focal lengths; none where the projection ends before.
std::optional<double> angleAt(Projection projection, double radius) {
  return visitProjection(projection, [radius](auto facts) { return facts.angleAt(radius); });
}

}  // namespace

double equivalentOnFilm(double focalPixels, int width, int height) {
  return focalPixels * kFilmDiagonal / diagonal(width, height);
}

std::optional<LensFacts> lensFromExif(const Exif& exif, int width, int height) {
  const Told told = read(exif, width, height);
  if (!told.film && !told.focal) return std::nullopt;
  requireWhole(told);

  std::optional<LensFacts> sensor = lensByResolution(told);
  if (!sensor && (!told.film || told.zoom)) sensor = lensByModel(told);
  if (sensor && told.zoom) {
    sensor->focalPixels *= *told.zoom;
    sensor->source += ", digital zoom " + text(*told.zoom);
    return sensor;
  }
  if (!told.film) {
    if (!sensor) refuseSensor(told);
    return sensor;
  }
  const double equivalent = *told.film;
  if (told.zoom)
    refuse("has a digital zoom of " + text(*told.zoom) + " and a 35 mm equivalent of " + text(equivalent) +
           " mm, which may count it or not: it is " + text(equivalent) + " or " + text(equivalent * *told.zoom));
  LensFacts film{equivalent * diagonal(width, height) / kFilmDiagonal, "35 mm equivalent " + text(equivalent) + " mm"};
  if (!sensor) return film;
  const double ratio = sensor->focalPixels / film.focalPixels;
  if (ratio <= kAgreement && ratio * kAgreement >= 1.0) return sensor;
  film.source += " (its " + sensor->source + " says " + text(ratio) + " times that)";
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
  throw std::invalid_argument("a " + std::string(nameOf(settings.projection)) + " lens with a focal length of " +
                              text(focalPixels) + " pixels does not fill the picture along either side");
}

}  // namespace parhelion
