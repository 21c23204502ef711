// SPDX-License-Identifier: Apache-2.0
#include "photo/photo_camera.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "math/rotation.h"
#include "photo/lens_from_exif.h"
#include "sky/camera.h"

namespace parhelion {

namespace {

std::string text(const char* format, double a, double b = 0.0, double c = 0.0) {
  char line[200];
  std::snprintf(line, sizeof line, format, a, b, c);
  return line;
}

/// Thousandths of degrees, never -0.
double shown(double radians) { return std::round(degrees(radians) * 1e3) / 1e3 + 0.0; }

/// The lens as far as it is known without field of view.
CameraSettings lensWithoutField(const Photograph& photograph, const LensClues& clues) {
  CameraSettings camera;
  camera.projection = clues.projection;
  camera.elevation = 0.0;
  camera.width = photograph.width;
  camera.height = photograph.height;
  if (clues.imageCircle) camera.imageCircle = *clues.imageCircle;
  camera.distortion = clues.distortion;
  camera.shift = clues.shift;
  return camera;
}

/// The angle between the middles of a picture's left and right border, by way of its centre, rad; none where the lens
/// does not reach them.
std::optional<double> angleAcross(const Camera& camera) {
  const double y = 0.5 * camera.height();
  const auto left = camera.directionAt({0.0, y}), right = camera.directionAt({camera.width() + 0.0, y});
  const auto middle = camera.directionAt({0.5 * camera.width(), y});
  if (!left || !right || !middle) return std::nullopt;
  const auto angle = [&](const Vec3& side) { return std::acos(std::clamp(glm::dot(side, *middle), -1.0, 1.0)); };
  return angle(*left) + angle(*right);
}

/// Whether the picture's own horizon is known: a panorama's is its middle row.
bool hasOwnHorizon(const CameraSettings& lens, const PointingClues& clues) {
  return isPanorama(lens.projection) && clues.known.empty();
}

/// What is to be taken for the sun's elevation before the camera is pointed; none: it is to be measured. What the
/// picture itself tells comes before what a scene was written with.
std::optional<double> sunElevationBefore(const PointingClues& clues, bool measurable) {
  if (clues.sunElevation) return clues.sunElevation;
  return measurable && clues.sun ? std::nullopt : clues.sceneSunElevation;
}

/// What to find the pointing from, in the order that pointLens() promises.
std::vector<PointingClue> placesOf(const CameraSettings& lens, const PointingClues& clues,
                                   std::optional<double> sunElevation) {
  std::vector<PointingClue> all;
  if (clues.sun) all.push_back({*clues.sun, 0.0, sunElevation});
  for (const Vec2& point : clues.horizon) all.push_back({point, std::nullopt, 0.0});
  all.insert(all.end(), clues.known.begin(), clues.known.end());
  if (!hasOwnHorizon(lens, clues)) return all;
  const double middle = 0.5 * lens.height, width = lens.width;
  for (const double x : {0.25 * width, 0.5 * width}) all.push_back({{x, middle}, std::nullopt, 0.0});
  return all;
}

/// What a user should know of how well the clues agree.
void remarkOn(const Pointing& pointing, std::size_t clues, std::vector<std::string>& remarks) {
  constexpr double kDisagreement = radians(0.25);  // half the sun's disc
  if (clues > 1)
    remarks.push_back(text("pointing: off by %.2f pixels, %.4f degrees (root mean square over %.0f places)",
                           pointing.rmsPixels(), degrees(pointing.rmsAngle()), static_cast<double>(clues)));
  if (pointing.rmsAngle() > kDisagreement)
    remarks.emplace_back(
        "warning: the places do not agree with each other; is one of them, the field of view or a sign wrong?");
  if (std::abs(pointing.roll) > 0.5 * kPi)
    remarks.emplace_back(
        "warning: this camera hangs upside down; is an azimuth's sign wrong? It is positive to the right");
}

/// The sun's elevation by where it is in the picture.
void measureSun(PhotoCamera& found, Vec2 sun) {
  const auto toSun = Camera(found.camera).directionAt(sun);
  found.sunElevation = skyPoint(*toSun).elevation;
  found.sunIsMeasured = true;
  found.remarks.push_back(text("sun: elevation %.3f degrees, measured in the picture", degrees(found.sunElevation)));
}

}  // namespace

std::optional<PhotoLens> findLens(const Photograph& photograph, const LensClues& clues) {
  CameraSettings camera = lensWithoutField(photograph, clues);
  if (showsHemispheres(camera.projection)) return PhotoLens{camera, describeLens(camera)};
  if (clues.fieldOfView) {
    camera.fieldOfViewAxis = clues.fieldOfView->axis;
    camera.fieldOfView = clues.fieldOfView->angle;
    return PhotoLens{camera, describeLens(camera)};
  }
  if (isPanorama(camera.projection)) {  // a whole sphere says it all
    camera.fieldOfView = 2.0 * kPi;
    return PhotoLens{camera, describeLens(camera)};
  }
  Exif exif = photograph.exif;
  if (clues.focal35mm) {
    exif = {};
    exif.focalLength35mm = clues.focal35mm;
  }
  const auto found = lensFromExif(exif, photograph.width, photograph.height);
  if (!found) return std::nullopt;
  camera = withFocalLength(camera, found->focalPixels);
  return PhotoLens{camera, describeLens(camera) + "; from " + found->source};
}

std::optional<PhotoCamera> pointLens(const CameraSettings& lens, const PointingClues& clues) {
  const bool level = hasOwnHorizon(lens, clues);
  const bool measurable = level || clues.horizon.size() >= 2 || clues.known.size() >= 2;
  const std::optional<double> sunElevation = sunElevationBefore(clues, measurable);
  if (!sunElevation && !measurable) return std::nullopt;

  const std::vector<PointingClue> places = placesOf(lens, clues, sunElevation);
  const bool levelUnlessSaid = places.size() == 1;
  const std::optional<double> turn = clues.roll ? clues.roll : levelUnlessSaid ? std::optional(0.0) : std::nullopt;
  const Pointing pointing = findPointing(lens, places, turn);
  if (!sunElevation && !clues.sun) return std::nullopt;
  PhotoCamera found;
  found.camera = lens;
  found.camera.azimuth = pointing.azimuth;
  found.camera.elevation = level ? 0.0 : pointing.elevation;
  found.camera.roll = level ? 0.0 : pointing.roll;
  remarkOn(pointing, places.size(), found.remarks);
  if (sunElevation)
    found.sunElevation = *sunElevation;
  else
    measureSun(found, *clues.sun);
  return found;
}

std::string describeLens(const CameraSettings& settings) {
  const Camera camera(settings);
  std::string words = text("lens: %.1f pixels", camera.focalLength());
  if (showsHemispheres(settings.projection)) return words + ", 180 degrees across each disc";
  const std::optional<double> across = angleAcross(camera);
  if (across) {
    words += text(", %.1f degrees from left to right", degrees(*across));
  } else {
    const double circle = settings.imageCircle > 0.0 ? settings.imageCircle : std::max(kPi, settings.fieldOfView);
    words += text(", %.1f degrees across its image circle", degrees(circle));
  }
  if (isPanorama(settings.projection)) return words;
  return words +
         text(", %.3g mm on 35 mm film", equivalentOnFilm(camera.focalLength(), settings.width, settings.height));
}

std::string describePointing(const CameraSettings& camera) {
  return text("camera: azimuth %.3f, elevation %.3f, roll %.3f degrees", shown(camera.azimuth), shown(camera.elevation),
              shown(camera.roll)) +
         text(", focal length %.1f pixels", Camera(camera).focalLength());
}

}  // namespace parhelion
