// SPDX-License-Identifier: Apache-2.0
#include "cli/photo_options.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "cli/run_options.h"
#include "cli/tally_run.h"
#include "math/rotation.h"
#include "photo/lens_from_exif.h"
#include "scene/names.h"
#include "scene/parse_scene.h"
#include "sky/camera.h"

namespace parhelion::cli {

namespace {

constexpr double kMostPixels = 1e6;  // from the picture's corner to a place, also outside it

/// Numbers between separators, as many as there are; empty where the text is anything else.
std::vector<double> numbers(std::string_view text, std::string_view separators) {
  std::vector<double> all;
  for (std::size_t i = 0;; ++i) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value) || std::abs(value) > kMostPixels) return {};
    all.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (text.empty()) return i == separators.size() ? all : std::vector<double>{};
    if (i == separators.size() || text.front() != separators[i]) return {};
    text.remove_prefix(1);
  }
}

CLI::Validator pattern(std::string separators, std::string expected) {
  return CLI::Validator(
      [=](const std::string& text) -> std::string {
        return numbers(text, separators).empty() ? "expected " + expected + ", not '" + text + "'" : "";
      },
      "");
}

std::vector<double> coefficients(const std::string& text) {
  for (const char* separators : {",,", ",", ""}) {
    if (const auto all = numbers(text, separators); !all.empty()) return all;
  }
  return {};
}

CLI::Validator distortionPattern() {
  return CLI::Validator(
      [](const std::string& text) -> std::string {
        return coefficients(text).empty() ? "expected K1, K1,K2 or K1,K2,K3, not '" + text + "'" : "";
      },
      "");
}

Vec2 place(const std::vector<double>& pair) { return {pair[0], pair[1]}; }

std::string text(const char* format, double a, double b = 0.0, double c = 0.0) {
  char line[200];
  std::snprintf(line, sizeof line, format, a, b, c);
  return line;
}

[[noreturn]] void refuse(const std::string& path, const std::string& problem) {
  throw CLI::ValidationError(path, problem);
}

/// Thousandths of degrees, never -0.
double shown(double radians) { return std::round(degrees(radians) * 1e3) / 1e3 + 0.0; }

/// Where the picture's camera looks, as the flags say it.
std::string described(const CameraSettings& camera) {
  return text("camera: azimuth %.3f, elevation %.3f, roll %.3f degrees", shown(camera.azimuth), shown(camera.elevation),
              shown(camera.roll)) +
         text(", focal length %.1f pixels", Camera(camera).focalLength());
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

}  // namespace

void PhotoOptions::addTo(CLI::App& command) {
  const auto angle = [&](const char* name, std::optional<double>& value, const char* about, double least, double most) {
    command.add_option(name, value, about)->type_name("DEG")->check(number(least, most));
  };
  command.add_option("--projection", projection, "The photograph's lens, as in scenes; rectilinear when left out")
      ->type_name("NAME")
      ->check(nameOfOne<Projection>());
  angle("--fov-horizontal", fovHorizontal, "Field of view from left to right; from the EXIF when left out", 0.1, 360.0);
  angle("--fov-vertical", fovVertical, "Field of view from bottom to top", 0.1, 360.0);
  angle("--fov-diagonal", fovDiagonal, "Field of view from corner to corner", 0.1, 360.0);
  command.add_option("--focal-35mm", focal35mm, "Focal length as on 35 mm film, instead of a field of view")
      ->type_name("MM")
      ->check(number(1.0, 10000.0));
  angle("--image-circle", imageCircle, "Full angle that a fisheye covers", 1.0, 360.0);
  command.add_option("--distortion", distortion, "Radial distortion of the lens; see camera.distortion of a scene")
      ->type_name("K1[,K2[,K3]]")
      ->check(distortionPattern());
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
}

bool PhotoOptions::given() const {
  return !projection.empty() || fovHorizontal || fovVertical || fovDiagonal || focal35mm || imageCircle ||
         !distortion.empty() || !sun.empty() || !horizon.empty() || !known.empty() || azimuth || elevation || roll;
}

CameraSettings PhotoOptions::lens(const Photograph& photograph, const std::string& path,
                                  std::vector<std::string>& remarks) const {
  CameraSettings camera;
  camera.projection = projection.empty() ? Projection::rectilinear : valueOf<Projection>(projection);
  camera.elevation = 0.0;
  camera.width = photograph.width;
  camera.height = photograph.height;
  if (imageCircle) camera.imageCircle = radians(*imageCircle);
  if (std::vector<double> k = coefficients(distortion); !k.empty()) {
    k.resize(3);
    camera.distortion = {k[0], k[1], k[2]};
  }
  const std::pair<const std::optional<double>&, FieldOfViewAxis> fields[] = {
      {fovHorizontal, FieldOfViewAxis::horizontal},
      {fovVertical, FieldOfViewAxis::vertical},
      {fovDiagonal, FieldOfViewAxis::diagonal}};
  int said = focal35mm ? 1 : 0;
  for (const auto& [field, axis] : fields) {
    if (!field) continue;
    ++said;
    camera.fieldOfViewAxis = axis;
    camera.fieldOfView = radians(*field);
  }
  if (said > 1)
    refuse(path, "its field of view is given more than once; one of the --fov-… and --focal-35mm is enough");
  if (said == 1 && !focal35mm) return camera;
  if (camera.projection == Projection::equirectangular) {  // a whole sphere says it all
    camera.fieldOfView = 2.0 * kPi;
    return camera;
  }
  Exif exif = photograph.exif;
  if (focal35mm) {
    exif = {};
    exif.focalLength35mm = focal35mm;
  }
  constexpr const char* kWays = "give --fov-horizontal, --fov-vertical, --fov-diagonal or --focal-35mm";
  try {
    const auto found = lensFromExif(exif, photograph.width, photograph.height);
    if (!found && photograph.width == 2 * photograph.height && !focal35mm)
      refuse(path, std::string("it does not say how wide its lens saw; for a panorama of the whole sphere give "
                               "--projection equirectangular, else ") +
                       (kWays + std::string("give ").size()));
    if (!found) refuse(path, std::string("it does not say how wide its lens saw; ") + kWays);
    remarks.push_back(text("lens: %.1f pixels, ", found->focalPixels) + found->source);
    return withFocalLength(camera, found->focalPixels);
  } catch (const std::invalid_argument& problem) {
    refuse(path, std::string(problem.what()) + "; " + kWays);
  }
}

std::vector<PointingClue> PhotoOptions::clues(std::optional<double> elevationOfSun) const {
  std::vector<PointingClue> all;
  if (!sun.empty()) all.push_back({place(numbers(sun, ",")), 0.0, elevationOfSun});
  for (const std::string& point : horizon) all.push_back({place(numbers(point, ",")), std::nullopt, 0.0});
  for (const std::string& point : known) {
    const std::vector<double> n = numbers(point, ",=,");
    all.push_back({place(n), radians(n[2]), radians(n[3])});
  }
  return all;
}

void PhotoOptions::pointByAngles(PhotoCamera& found, const std::string& path,
                                 std::optional<double> elevationOfSun) const {
  if (!azimuth || !elevation) refuse(path, "--azimuth and --elevation go together");
  if (!sun.empty() || !horizon.empty() || !known.empty())
    refuse(path, "where the camera pointed is given twice, by --azimuth and --elevation and by places in the picture");
  if (!elevationOfSun) refuse(path, "how high the sun stood is not known; give --sun-elevation");
  found.camera.azimuth = radians(*azimuth);
  found.camera.elevation = radians(*elevation);
  found.camera.roll = radians(roll.value_or(0.0));
  found.sunElevation = *elevationOfSun;
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

void PhotoOptions::pointByClues(PhotoCamera& found, const std::string& path,
                                std::optional<double> sceneSunElevation) const {
  // What the picture itself tells of the sun's height comes before what a scene was written with.
  const bool panorama = found.camera.projection == Projection::equirectangular && known.empty();
  const bool measured = panorama || horizon.size() >= 2 || known.size() >= 2;
  std::optional<double> elevationOfSun = measured ? std::nullopt : sceneSunElevation;
  if (sunElevation) elevationOfSun = radians(*sunElevation);
  if (sun.empty() && !elevationOfSun) elevationOfSun = sceneSunElevation;
  if (!measured && !elevationOfSun) refuse(path, "how high the sun stood is not known; give --sun-elevation");

  std::vector<PointingClue> given = clues(elevationOfSun);
  if (panorama) {  // a panorama's horizon is its middle row
    const double middle = 0.5 * found.camera.height, width = found.camera.width;
    for (const double x : {0.25 * width, 0.5 * width}) given.push_back({{x, middle}, std::nullopt, 0.0});
  }
  const bool levelUnlessSaid = given.size() == 1;
  const std::optional<double> turn = roll              ? std::optional(radians(*roll))
                                     : levelUnlessSaid ? std::optional(0.0)
                                                       : std::nullopt;
  try {
    const Pointing pointing = findPointing(found.camera, given, turn);
    found.camera.azimuth = pointing.azimuth;
    found.camera.elevation = panorama ? 0.0 : pointing.elevation;
    found.camera.roll = panorama ? 0.0 : pointing.roll;
    remarkOn(pointing, given.size(), found.remarks);
  } catch (const std::invalid_argument& problem) {
    refuse(path, withNames(problem.what()));
  }
  if (elevationOfSun) {
    found.sunElevation = *elevationOfSun;
    return;
  }
  if (sun.empty()) refuse(path, "how high the sun stood is not known; give --sun-elevation");
  const auto toSun = Camera(found.camera).directionAt(place(numbers(sun, ",")));
  found.sunElevation = skyPoint(*toSun).elevation;
  found.remarks.push_back(text("sun: elevation %.3f degrees, measured in the picture", degrees(found.sunElevation)));
  if (found.sunElevation < 0.0)
    found.remarks.emplace_back(
        "warning: the sun is below the horizon; does the camera hang upside down? Then give --roll");
}

void PhotoOptions::point(PhotoCamera& found, const std::string& path, std::optional<double> sceneSunElevation) const {
  if (azimuth || elevation) {
    return pointByAngles(found, path, sunElevation ? std::optional(radians(*sunElevation)) : sceneSunElevation);
  }
  if (sun.empty() && known.empty())
    refuse(path,
           "where the camera pointed is not known; give --sun X,Y with --sun-elevation and --roll, or --sun with two "
           "--horizon X,Y, or two --known X,Y=AZ,EL, or --azimuth, --elevation and --roll");
  pointByClues(found, path, sceneSunElevation);
}

PhotoCamera PhotoOptions::camera(const Photograph& photograph, const std::string& path,
                                 std::optional<double> sceneSunElevation) const {
  PhotoCamera found;
  std::optional<double> elevationOfSun = sceneSunElevation;
  if (sunElevation) elevationOfSun = radians(*sunElevation);
  if (const auto scene = photograph.text.find(kSceneKey); !given() && scene != photograph.text.end()) {
    const Scene carried = parseScene(scene->second, path).scene;
    found.camera = carried.camera;
    found.sunElevation = elevationOfSun.value_or(carried.sun.elevation);
    if (found.camera.width != photograph.width || found.camera.height != photograph.height)
      refuse(path, "the picture is not of the size its embedded scene says; give its camera by options");
    return found;
  }
  found.camera = lens(photograph, path, found.remarks);
  point(found, path, sceneSunElevation);
  found.remarks.push_back(described(found.camera));
  return found;
}

}  // namespace parhelion::cli
