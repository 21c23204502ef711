// SPDX-License-Identifier: Apache-2.0
#include "scene/schema.h"

#include <doctest/doctest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "scene_support.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

using Json = nlohmann::json;

Json schema() { return Json::parse(sceneSchema()); }

/// The schemas of the tables of a scene by name; of the lists of populations and layers, that of an element.
Json tables() {
  Json result = schema()["properties"];
  for (const char* list : {"population", "layer"}) result[list] = result[list]["items"];
  return result;
}

/// The keys a table accepts, as the parser says when it meets an unknown one.
std::string acceptedIn(const std::string& text) {
  const std::string hint = errorsOf(text).at(0).hint;
  return hint.substr(hint.find("accepted: ") + 10);
}

std::string keysOf(const Json& table) {
  std::string list;
  for (const auto& [key, value] : table["properties"].items()) list += (list.empty() ? "" : ", ") + key;
  return list;
}

}  // namespace

TEST_CASE("the schema is draft-04 JSON and asks for populations") {
  CHECK(schema()["$schema"] == "http://json-schema.org/draft-04/schema#");
  CHECK(schema()["required"] == Json{"population"});
  CHECK(schema()["properties"]["population"]["minItems"] == 1);
}

TEST_CASE("the schema has exactly the keys that the parser accepts") {
  CHECK(keysOf(schema()) == acceptedIn("zzz = 1\n[[population]]"));
  for (const char* name : {"sun", "ice", "camera", "sky", "observer", "trace", "recon"}) {
    CAPTURE(name);
    CHECK(keysOf(tables()[name]) == acceptedIn(std::string("[").append(name) + "]\nzzz = 1\n[[population]]"));
  }
  CHECK(keysOf(tables()["population"]) == acceptedIn("[[population]]\nzzz = 1"));
  CHECK(keysOf(tables()["layer"]) == acceptedIn("[[layer]]\nname = 'a'\nzzz = 1\n[[population]]"));
  CHECK(keysOf(tables()["population"]["properties"]["orientation"]["anyOf"][1]) ==
        acceptedIn("[[population]]\norientation = { zenith = 1, zzz = 1 }"));
}

TEST_CASE("every table refuses other keys and every key is described") {
  const std::function<void(const Json&)> walk = [&](const Json& node) {
    if (node.contains("properties")) {
      CHECK(node["additionalProperties"] == false);
      CHECK(node["type"] == "object");
    }
    for (const Json& child : node) {
      if (child.is_structured()) walk(child);
    }
  };
  walk(schema());
  for (const Json& table : tables()) {
    if (!table.contains("properties")) continue;
    for (const Json& key : table["properties"]) CHECK(key["description"].get<std::string>().size() > 10);
  }
}

TEST_CASE("the schema's defaults are those of the settings") {
  const Json t = tables();
  const auto preset = [&](const char* table, const char* key) { return t[table]["properties"][key]["default"]; };
  CHECK(preset("sun", "elevation") == degrees(SunSettings{}.elevation));
  CHECK(preset("sun", "diameter").get<double>() == doctest::Approx(degrees(SunSettings{}.diameter)).epsilon(1e-12));
  CHECK(preset("sun", "spectrum") == "sun");
  CHECK(preset("sun", "visible") == SunSettings{}.visible);
  CHECK(preset("ice", "index") == "warren-brandt");
  CHECK(preset("population", "weight") == PopulationSettings{}.weight);
  CHECK(preset("population", "slope").get<double>() == doctest::Approx(degrees(PyramidSettings{}.slope)));
  CHECK(preset("camera", "projection") == "fisheye-equal-area");
  CHECK(preset("camera", "elevation") == degrees(CameraSettings{}.elevation));
  CHECK(preset("camera", "resolution") == Json{CameraSettings{}.width, CameraSettings{}.height});
  CHECK(preset("trace", "rays") == TraceSettings{}.rays);
  CHECK(preset("trace", "seed") == TraceSettings{}.seed);
  CHECK(preset("trace", "engine") == "auto");
  CHECK(preset("recon", "method") == "adaptive");
}

TEST_CASE("a scene that writes out every default is the scene that leaves them out") {
  const Json t = tables();
  std::string text = "[[population]]\n";
  for (const char* name : {"sun", "ice", "camera", "sky", "observer", "trace", "recon"}) {
    text.append("[").append(name).append("]\n");
    for (const auto& [key, value] : t[name]["properties"].items()) {
      if (value.contains("default")) text += key + " = " + value["default"].dump() + '\n';
    }
  }
  const Scene written = sceneOf(text);
  const Scene leftOut = sceneOf(kPopulation);
  CHECK(written.sun.diameter == leftOut.sun.diameter);
  CHECK(written.camera.fieldOfView == leftOut.camera.fieldOfView);
  CHECK(written.camera.elevation == leftOut.camera.elevation);
  CHECK(written.trace.rays == leftOut.trace.rays);
  CHECK(written.trace.path == leftOut.trace.path);
}

TEST_CASE("the schema's ranges and names are the parser's") {
  const Json t = tables();
  const Json& elevation = t["sun"]["properties"]["elevation"];
  CHECK(elevation["minimum"] == -90);
  CHECK(elevation["maximum"] == 90);
  const Json& slope = t["population"]["properties"]["slope"];
  CHECK(slope["anyOf"][0]["exclusiveMinimum"] == true);
  CHECK(slope["anyOf"][0]["exclusiveMaximum"] == true);
  for (const Json& name : t["camera"]["properties"]["projection"]["enum"]) {
    CAPTURE(name);
    CHECK(errorsOf("camera.projection = " + name.dump() + "\n[[population]]").empty());
  }
  for (const Json& name : t["population"]["properties"]["orientation"]["anyOf"][0]["enum"]) {
    CAPTURE(name);
    CHECK(errorsOf("[[population]]\norientation = " + name.dump()).empty());
  }
}
