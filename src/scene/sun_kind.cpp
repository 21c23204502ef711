// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include "optics/solar_position.h"
#include "scene/scene_keys.h"

namespace parhelion {

namespace {

/// To what people read and write: the algorithm is exact to three of these units.
double roundedAngle(double angle) {
  constexpr double kUnit = 1e-4;  // degrees
  return radians(roundToTwelveDigits(kUnit * std::round(degrees(angle) / kUnit)));
}

/// Complains where keys say the same twice, or not all that is needed, about the first of them; false then.
bool checkSun(TableReader& reader) {
  bool good = true;
  const auto reject = [&](std::string_view key, const std::string& message, const std::string& hint) {
    reader.reject(key, message, hint);
    good = false;
  };
  if (!reader.has("date")) {
    for (const char* key : {"latitude", "longitude", "refraction"})
      if (good && reader.has(key))
        reject(key, std::string("'") + key + "' is of use only with a 'date'",
               std::string("leave it out, as -D sun.") + key + "= does");
    return good;
  }
  for (const char* key : {"elevation", "azimuth"})
    if (good && reader.has(key))
      reject(key, std::string("the sun's ") + key + " is given twice, by '" + key + "' and by 'date'",
             "leave one of them out, as -D sun." + std::string(key) + "= does");
  for (const char* key : {"latitude", "longitude"})
    if (good && !reader.has(key))
      reject("date", std::string("a 'date' tells where the sun stands only with a place: '") + key + "' is missing",
             "in degrees, north and east positive");
  return good;
}

}  // namespace

bool kinds::SunTable::read(const Value& in, SunSettings& out) const {
  const toml::table* table = in.node.as_table();
  if (!table) return in.mustBe("a table");
  TableReader reader(*table, "[sun]", in.complaints);
  SunKeys keys;
  visitKeys(reader, keys);
  reader.rejectUnknown();
  out = keys.sun;
  if (!checkSun(reader) || !keys.date || !keys.latitude || !keys.longitude) return true;

  const SunPosition sun = sunFrom({*keys.latitude, *keys.longitude}, *keys.date);
  const double lift = keys.refraction.value_or(true) ? refractionOfAir(sun.elevation) : 0.0;
  out.elevation = roundedAngle(sun.elevation + lift);
  out.azimuth = roundedAngle(sun.azimuth);
  return true;
}

Json kinds::SunTable::schema() const { return tableSchema<SunKeys>(); }

}  // namespace parhelion
