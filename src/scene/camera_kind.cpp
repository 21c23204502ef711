// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <stdexcept>
#include <string>

#include "scene/scene_keys.h"
#include "sky/camera.h"
#include "sky/projections.h"

namespace parhelion {

namespace {

void checkAngle(TableReader& reader, std::string_view key, double angle, const Range& range, Projection projection) {
  const double inDegrees = roundToTwelveDigits(degrees(angle));
  if (range.contains(inDegrees)) return;
  reader.reject(key, std::string("'").append(key) + "' of a projection \"" + std::string(nameOf(projection)) +
                         "\" must be " + range.text() + " degrees, not " + formatNumber(inDegrees));
}

/// "a globe always shows one whole hemisphere"
std::string hemispheresText(Projection projection) {
  return std::string("a ").append(nameOf(projection)) + " always shows " +
         (discs(projection) == 1 ? "one whole hemisphere" : "two whole hemispheres");
}

void checkFieldOfView(TableReader& reader, const FieldOfViewKey& key, double angle, Projection projection) {
  if (showsHemispheres(projection)) {
    reader.reject(key.name, hemispheresText(projection) + "; it has no field of view to choose",
                  "leave it out, as -D camera." + std::string(key.name) + "= does");
    return;
  }
  visitProjection(projection, [&](auto facts) {
    if (!facts.hasDiagonal && key.axis == FieldOfViewAxis::diagonal) {
      reader.reject(key.name, std::string("an ").append(nameOf(projection)) + " image has no diagonal field of view",
                    "give fov_horizontal or fov_vertical");
      return;
    }
    const bool isVertical = key.axis == FieldOfViewAxis::vertical;
    checkAngle(reader, key.name, angle, isVertical ? facts.verticalFieldOfView : facts.fieldOfView, projection);
  });
}

/// The camera knows what cannot be: a distortion that folds the picture over, a shift beyond what the lens shows.
template <class Setting>
void checkByCamera(TableReader& reader, std::string_view key, const CameraSettings& camera,
                   Setting CameraSettings::*member) {
  if (camera.*member == Setting()) return;
  CameraSettings ideal = camera;
  ideal.*member = Setting();
  try {
    const Camera works(ideal);
  } catch (const std::invalid_argument&) {
    return;  // something else is wrong and has been said
  }
  try {
    const Camera works(camera);
  } catch (const std::invalid_argument& problem) {
    reader.reject(key, problem.what());
  }
}

/// What the lens covers obeys the same limits as what the image shows of it.
void checkImageCircle(TableReader& reader, const CameraSettings& camera) {
  if (camera.imageCircle == 0.0) return;
  visitProjection(camera.projection, [&](auto facts) {
    if (facts.showsHemispheres) {
      reader.reject("image_circle", hemispheresText(camera.projection) + "; it has no image circle to choose");
    } else if (facts.isFisheye) {
      checkAngle(reader, "image_circle", camera.imageCircle, facts.fieldOfView, camera.projection);
    } else {
      reader.reject("image_circle", "only fisheye lenses have an image circle");
    }
  });
}

/// Two hemispheres side by side have halves of the same width.
void checkResolution(TableReader& reader, const CameraSettings& camera) {
  if (camera.width % discs(camera.projection) == 0) return;
  reader.reject("resolution", hemispheresText(camera.projection) + " side by side: its width must be even, not " +
                                  std::to_string(camera.width));
}

void applyFieldOfView(TableReader& reader, const CameraKeys& keys, CameraSettings& camera) {
  std::string_view given;
  for (std::size_t i = 0; i < kFieldOfViewKeys.size(); ++i) {
    const FieldOfViewKey& key = kFieldOfViewKeys[i];
    if (!reader.has(key.name)) continue;
    if (!given.empty()) {
      reader.reject(key.name,
                    std::string("the field of view is given twice, by '").append(given) + "' and by '" +
                        std::string(key.name) + "'",
                    "the other one follows from the resolution");
    }
    given = key.name;
    const std::optional<double> angle = keys.fieldsOfView[i];
    if (!angle) continue;
    checkFieldOfView(reader, key, *angle, camera.projection);
    camera.fieldOfViewAxis = key.axis;
    camera.fieldOfView = *angle;
  }
}

}  // namespace

CameraSettings defaultCamera(Projection projection) {
  CameraSettings camera;
  camera.projection = projection;
  visitProjection(projection, [&](auto facts) {
    camera.fieldOfView = radians(facts.defaultFieldOfView);
    camera.elevation = radians(facts.defaultElevation);
    camera.width = facts.defaultWidthPerHeight * camera.height;
  });
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
  if (reader.rejected("projection")) return false;  // what else is wrong would depend on it
  applyFieldOfView(reader, keys, out);
  checkImageCircle(reader, out);
  checkResolution(reader, out);
  if (!reader.rejected("shift")) checkByCamera(reader, "shift", out, &CameraSettings::shift);
  if (!reader.rejected("distortion")) checkByCamera(reader, "distortion", out, &CameraSettings::distortion);
  return true;
}

Json kinds::CameraTable::schema() const { return tableSchema<CameraKeys>(); }

}  // namespace parhelion
