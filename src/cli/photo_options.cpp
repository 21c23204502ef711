// SPDX-License-Identifier: Apache-2.0
#include "cli/photo_options.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cli/number_options.h"
#include "cli/run_options.h"
#include "math/names.h"
#include "render/scene_attributes.h"
#include "scene/parse_scene.h"

namespace parhelion::cli {

namespace {

CLI::Validator pattern(std::string separators, std::string expected) {
  return CLI::Validator(
      [=](const std::string& text) -> std::string {
        return numbersIn(text, separators).empty() ? expectedNot(expected, text) : "";
      },
      "");
}

/// One to three numbers; none where the text is anything else.
std::vector<double> coefficients(const std::string& text) {
  const std::vector<double> all = commaSeparated(text);
  return all.size() <= 3 ? all : std::vector<double>{};
}

CLI::Validator distortionPattern() {
  return CLI::Validator(
      [](const std::string& text) -> std::string {
        return coefficients(text).empty() ? expectedNot("K1, K1,K2 or K1,K2,K3", text) : "";
      },
      "");
}

Vec2 place(const std::vector<double>& pair) { return {pair[0], pair[1]}; }

std::optional<double> inRadians(const std::optional<double>& degrees) {
  return degrees ? std::optional(radians(*degrees)) : std::nullopt;
}

[[noreturn]] void refuse(const std::string& path, const std::string& problem) {
  throw CLI::ValidationError(path, problem);
}

constexpr const char* kWays = "--fov-horizontal, --fov-vertical, --fov-diagonal or --focal-35mm";
constexpr const char* kNoSunElevation = "how high the sun stood is not known; give --sun-elevation";

}  // namespace

std::string sizeText(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height) + " pixels";
}

bool hasShapeOf(const Photograph& photograph, const CameraSettings& camera) {
  const double scale = static_cast<double>(photograph.width) / camera.width;
  const double across = std::abs(photograph.height - scale * camera.height);
  return across <= std::max(1.0, scale);
}

void PhotoOptions::addTo(CLI::App& command) {
  const auto angle = [&](const char* name, std::optional<double>& value, const char* about, double least, double most) {
    command.add_option(name, value, about)->type_name("DEG")->transform(number(least, most));
  };
  command.add_option("--projection", projection, "The photograph's lens, as in scenes; rectilinear when left out")
      ->type_name("NAME")
      ->check(nameOfOne<Projection>());
  angle("--fov-horizontal", fovHorizontal, "Field of view from left to right; from the EXIF when left out", 0.1, 360.0);
  angle("--fov-vertical", fovVertical, "Field of view from bottom to top", 0.1, 360.0);
  angle("--fov-diagonal", fovDiagonal, "Field of view from corner to corner", 0.1, 360.0);
  command.add_option("--focal-35mm", focal35mm, "Focal length as on 35 mm film, instead of a field of view")
      ->type_name("MM")
      ->transform(number(1.0, 10000.0));
  angle("--image-circle", imageCircle, "Full angle that a fisheye covers", 1.0, 360.0);
  command.add_option("--distortion", distortion, "Radial distortion of the lens; see camera.distortion of a scene")
      ->type_name("K1[,K2[,K3]]")
      ->check(distortionPattern());
  command
      .add_option("--shift", shift,
                  "How far the picture lies to the right of the optical axis and above it; see camera.shift of a scene")
      ->type_name("X,Y")
      ->check(pattern(",", "X,Y in focal lengths"));
  command.add_option("--sun", sun, "Where the sun is in the picture, or outside it, pixels from its upper left corner")
      ->type_name("X,Y")
      ->check(pattern(",", "X,Y in pixels"));
  angle("--sun-elevation", sunElevation, "Elevation of the sun; the scene's when left out", -90.0, 90.0);
  command.add_option("--horizon", horizon, "A point of the horizon; two or more")
      ->type_name("X,Y")
      ->allow_extra_args(false)
      ->check(pattern(",", "X,Y in pixels"));
  command.add_option("--known", known, "A place of known direction: azimuth from the sun, to the right, and elevation")
      ->type_name("X,Y=AZ,EL")
      ->allow_extra_args(false)
      ->check(pattern(",=,", "X,Y=AZIMUTH,ELEVATION, pixels and degrees"));
  angle("--azimuth", azimuth, "Azimuth of the optical axis from the sun, where that is known itself", -360.0, 360.0);
  angle("--elevation", elevation, "Elevation of the optical axis", -90.0, 90.0);
  angle("--roll", roll, "Clockwise turn of the camera; with --sun alone 0 when left out", -360.0, 360.0);
  command.add_flag("--assume-srgb", assumeSrgb, "Take the picture's colours for sRGB, whatever its profile says");
  command.add_flag("--edited", edited, "Take an EXR of parhelion as it is, though another program has changed it");
}

bool PhotoOptions::given() const {
  return !projection.empty() || fovHorizontal || fovVertical || fovDiagonal || focal35mm || imageCircle ||
         !distortion.empty() || !shift.empty() || !sun.empty() || !horizon.empty() || !known.empty() || azimuth ||
         elevation || roll;
}

LensClues PhotoOptions::lensClues(const std::string& path) const {
  LensClues clues;
  if (!projection.empty()) clues.projection = valueOf<Projection>(projection);
  clues.imageCircle = inRadians(imageCircle);
  clues.focal35mm = focal35mm;
  if (std::vector<double> k = coefficients(distortion); !k.empty()) {
    k.resize(3);
    clues.distortion = {k[0], k[1], k[2]};
  }
  if (!shift.empty()) {
    const Vec2 by = place(numbersIn(shift, ","));
    constexpr double kMost = 10.0;  // as in scenes
    if (!(std::abs(by.x) <= kMost && std::abs(by.y) <= kMost))
      refuse(path, "--shift " + shift + " is in focal lengths, from -10 to 10 each");
    clues.shift = {by.x, by.y};
  }
  const std::pair<const std::optional<double>&, FieldOfViewAxis> fields[] = {
      {fovHorizontal, FieldOfViewAxis::horizontal},
      {fovVertical, FieldOfViewAxis::vertical},
      {fovDiagonal, FieldOfViewAxis::diagonal}};
  int said = focal35mm ? 1 : 0;
  for (const auto& [field, axis] : fields) {
    if (!field) continue;
    ++said;
    clues.fieldOfView = {axis, radians(*field)};
  }
  if (said > 1)
    refuse(path, "its field of view is given more than once; one of the --fov-… and --focal-35mm is enough");
  return clues;
}

/// A picture of hemispheres leaves nothing to be said of its lens.
void requireHemispheres(const Photograph& photograph, const std::string& path, const LensClues& clues) {
  const std::string name(nameOf(clues.projection));
  if (isMirrored(clues.projection)) refuse(path, "no photograph shows the sky from outside, as a " + name + " does");
  if (clues.fieldOfView || clues.focal35mm || clues.imageCircle || !clues.distortion.none() ||
      !(clues.shift == Shift()))
    refuse(path, "a " + name +
                     " always shows two whole hemispheres; leave out field of view, focal length, image circle, "
                     "distortion and shift");
  if (photograph.width % 2 != 0)
    refuse(path, "it is " + std::to_string(photograph.width) +
                     " pixels wide; two hemispheres side by side need an even width");
}

PhotoLens PhotoOptions::lens(const Photograph& photograph, const std::string& path) const {
  const LensClues clues = lensClues(path);
  if (showsHemispheres(clues.projection)) requireHemispheres(photograph, path, clues);
  if (isPanorama(clues.projection) && !(clues.shift == Shift()))
    refuse(path, "a panorama has no optical axis that --shift could move; leave it out");
  try {
    if (const std::optional<PhotoLens> found = findLens(photograph, clues)) return *found;
  } catch (const std::invalid_argument& problem) {
    refuse(path, std::string(problem.what()) + "; give " + kWays);
  }
  const std::string unknown = "it does not say how wide its lens saw; ";
  if (photograph.width == 2 * photograph.height && !focal35mm)
    refuse(path, unknown + "for a panorama of the whole sphere give --projection equirectangular, else " + kWays);
  refuse(path, unknown + "give " + kWays);
}

PointingClues PhotoOptions::pointingClues(std::optional<double> sceneSunElevation) const {
  PointingClues clues;
  if (!sun.empty()) clues.sun = place(numbersIn(sun, ","));
  for (const std::string& point : horizon) clues.horizon.push_back(place(numbersIn(point, ",")));
  for (const std::string& point : known) {
    const std::vector<double> n = numbersIn(point, ",=,");
    clues.known.push_back({place(n), radians(n[2]), radians(n[3])});
  }
  clues.roll = inRadians(roll);
  clues.sunElevation = inRadians(sunElevation);
  clues.sceneSunElevation = sceneSunElevation;
  return clues;
}

PhotoCamera PhotoOptions::pointByAngles(const CameraSettings& lens, const std::string& path,
                                        std::optional<double> elevationOfSun) const {
  if (!azimuth || !elevation) refuse(path, "--azimuth and --elevation go together");
  if (!sun.empty() || !horizon.empty() || !known.empty())
    refuse(path, "where the camera pointed is given twice, by --azimuth and --elevation and by places in the picture");
  if (!elevationOfSun) refuse(path, kNoSunElevation);
  PhotoCamera found;
  found.camera = lens;
  found.camera.azimuth = radians(*azimuth);
  found.camera.elevation = radians(*elevation);
  found.camera.roll = radians(roll.value_or(0.0));
  found.sunElevation = *elevationOfSun;
  return found;
}

/// A message about "clue 2" in terms of the options that gave the clues.
std::string PhotoOptions::withNames(std::string message) const {
  std::vector<std::string> names;
  if (!sun.empty()) names.push_back("--sun " + sun);
  for (const std::string& point : horizon) names.push_back("--horizon " + point);
  for (const std::string& point : known) names.push_back("--known " + point);
  for (std::size_t k = names.size(); k-- > 0;) {
    const std::string clue = "clue " + std::to_string(k + 1);
    for (std::size_t at = message.find(clue); at != std::string::npos; at = message.find(clue, at + names[k].size()))
      message.replace(at, clue.size(), names[k]);
  }
  return message;
}

PhotoCamera PhotoOptions::pointByClues(const CameraSettings& lens, const std::string& path,
                                       std::optional<double> sceneSunElevation) const {
  std::optional<PhotoCamera> found;
  try {
    found = pointLens(lens, pointingClues(sceneSunElevation));
  } catch (const std::invalid_argument& problem) {
    refuse(path, withNames(problem.what()));
  }
  if (!found) refuse(path, kNoSunElevation);
  if (found->sunIsMeasured && found->sunElevation < 0.0)
    found->remarks.emplace_back(
        "warning: the sun is below the horizon; does the camera hang upside down? Then give --roll");
  return *found;
}

PhotoCamera PhotoOptions::point(const CameraSettings& lens, const std::string& path,
                                std::optional<double> sceneSunElevation) const {
  if (azimuth || elevation)
    return pointByAngles(lens, path, sunElevation ? inRadians(sunElevation) : sceneSunElevation);
  if (sun.empty() && known.empty())
    refuse(path,
           "where the camera pointed is not known; give --sun X,Y with --sun-elevation and --roll, or --sun with two "
           "--horizon X,Y, or two --known X,Y=AZ,EL, or --azimuth, --elevation and --roll");
  return pointByClues(lens, path, sceneSunElevation);
}

PhotoCamera PhotoOptions::camera(const Photograph& photograph, const std::string& path,
                                 std::optional<double> sceneSunElevation) const {
  if (const auto scene = photograph.text.find(kSceneKey); !given() && scene != photograph.text.end()) {
    const Scene carried = parseScene(scene->second, path).scene;
    PhotoCamera found;
    found.camera = carried.camera;
    found.sunElevation = (sunElevation ? inRadians(sunElevation) : sceneSunElevation).value_or(carried.sun.elevation);
    if (!hasShapeOf(photograph, carried.camera))
      refuse(path, "the picture is " + sizeText(photograph.width, photograph.height) + ", its scene says " +
                       sizeText(carried.camera.width, carried.camera.height) +
                       ": it must have been cropped; give its camera by options");
    found.camera.width = photograph.width;
    found.camera.height = photograph.height;
    return found;
  }
  const PhotoLens found = lens(photograph, path);
  PhotoCamera camera = point(found.camera, path, sceneSunElevation);
  if (!found.remark.empty()) camera.remarks.insert(camera.remarks.begin(), found.remark);
  camera.remarks.push_back(describePointing(camera.camera));
  return camera;
}

}  // namespace parhelion::cli
