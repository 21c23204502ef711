// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <stdexcept>
#include <string>

#include "scene/scene_keys.h"
#include "sky/camera.h"

namespace parhelion {

namespace {

/// What is special about a projection; angles in degrees.
struct ProjectionLimits {
  double defaultFov;
  Range horizontal;
  Range vertical;
};

ProjectionLimits limitsOf(Projection projection) {
  constexpr Range kBelow180{0, 180, true, true}, kTo180{0, 180, true}, kBelow360{0, 360, true, true},
      kTo360{0, 360, true};
  switch (projection) {
    case Projection::rectilinear:
      return {60, kBelow180, kBelow180};
    case Projection::fisheyeEqualArea:
      return {180, kTo360, kTo360};
    case Projection::fisheyeEquidistant:
      return {180, kTo360, kTo360};
    case Projection::fisheyeStereographic:
      return {180, kBelow360, kBelow360};
    case Projection::fisheyeOrthographic:
      return {180, kTo180, kTo180};
    case Projection::equirectangular:
      return {360, kTo360, kTo180};
  }
  return {};
}

/// One of the three ways to give the field of view.
struct FieldOfView {
  std::string_view key;
  FieldOfViewAxis axis;
  std::optional<double> angle;  // rad
};

void checkAngle(TableReader& reader, std::string_view key, double angle, const Range& range, Projection projection) {
  const double inDegrees = roundToTwelveDigits(degrees(angle));
  if (range.contains(inDegrees)) return;
  reader.reject(key, std::string("'").append(key) + "' of a projection \"" + std::string(nameOf(projection)) +
                         "\" must be " + range.text() + " degrees, not " + formatNumber(inDegrees));
}

void checkFieldOfView(TableReader& reader, const FieldOfView& fov, Projection projection) {
  if (projection == Projection::equirectangular && fov.axis == FieldOfViewAxis::diagonal) {
    reader.reject(fov.key, "an equirectangular image has no diagonal field of view",
                  "give fov_horizontal or fov_vertical");
    return;
  }
  const ProjectionLimits limits = limitsOf(projection);
  const Range& range = fov.axis == FieldOfViewAxis::vertical ? limits.vertical : limits.horizontal;
  checkAngle(reader, fov.key, *fov.angle, range, projection);
}

/// The camera knows whether its distortion folds the picture over.
void checkDistortion(TableReader& reader, const CameraSettings& camera) {
  if (camera.distortion.none()) return;
  CameraSettings ideal = camera;
  ideal.distortion = {};
  try {
    const Camera works(ideal);
  } catch (const std::invalid_argument&) {
    return;  // something else is wrong and has been said
  }
  try {
    const Camera works(camera);
  } catch (const std::invalid_argument& problem) {
    reader.reject("distortion", problem.what());
  }
}

/// What the lens covers obeys the same limits as what the image shows of it.
void checkImageCircle(TableReader& reader, std::optional<double> circle, Projection projection) {
  if (!circle) return;
  if (!isFisheye(projection)) {
    reader.reject("image_circle", "only fisheye lenses have an image circle");
  } else {
    checkAngle(reader, "image_circle", *circle, limitsOf(projection).horizontal, projection);
  }
}

void applyFieldOfView(TableReader& reader, const CameraKeys& keys, CameraSettings& camera) {
  const FieldOfView offered[] = {{"fov_horizontal", FieldOfViewAxis::horizontal, keys.fovHorizontal},
                                 {"fov_vertical", FieldOfViewAxis::vertical, keys.fovVertical},
                                 {"fov_diagonal", FieldOfViewAxis::diagonal, keys.fovDiagonal}};
  std::string_view given;
  for (const FieldOfView& fov : offered) {
    if (!reader.has(fov.key)) continue;
    if (!given.empty()) {
      reader.reject(fov.key,
                    std::string("the field of view is given twice, by '").append(given) + "' and by '" +
                        std::string(fov.key) + "'",
                    "the other one follows from the resolution");
    }
    given = fov.key;
    if (!fov.angle) continue;
    checkFieldOfView(reader, fov, camera.projection);
    camera.fieldOfViewAxis = fov.axis;
    camera.fieldOfView = *fov.angle;
  }
}

}  // namespace

CameraSettings defaultCamera(Projection projection) {
  CameraSettings camera;
  camera.projection = projection;
  camera.fieldOfView = radians(limitsOf(projection).defaultFov);
  if (!isFisheye(projection)) camera.elevation = 0.0;
  if (projection == Projection::equirectangular) camera.width = 2 * camera.height;
  return camera;
}

bool kinds::CameraTable::read(const Value& in, CameraSettings& out) const {
  const toml::table* table = in.node.as_table();
  if (!table) return in.mustBe("a table");
  TableReader reader(*table, "[camera]", in.complaints);
  CameraKeys keys;
  visitKeys(reader, keys);
  reader.rejectUnknown();

  out = keys.camera;
  out.width = keys.resolution[0];
  out.height = keys.resolution[1];
  out.imageCircle = keys.imageCircle.value_or(0.0);
  if (reader.rejected("projection")) return false;  // what else is wrong would depend on it
  applyFieldOfView(reader, keys, out);
  checkImageCircle(reader, keys.imageCircle, out.projection);
  if (!reader.rejected("distortion")) checkDistortion(reader, out);
  return true;
}

Json kinds::CameraTable::schema() const { return tableSchema<CameraKeys>(); }

}  // namespace parhelion
