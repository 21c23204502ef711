// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/number_options.h"
#include "cli/outputs.h"
#include "cli/run_options.h"
#include "cli/say.h"
#include "cli/scene_input.h"
#include "math/rotation.h"
#include "render/measurements.h"
#include "render/scene_attributes.h"
#include "render/traced_sky.h"
#include "view/crystal_drawing.h"

namespace parhelion::cli {

namespace {

struct ReplayOptions {
  std::string scene;
  std::vector<std::string> overrides;
  std::uint64_t ray = 0;
  bool json = false, overwrite = false;
  std::string svg;
};

nlohmann::ordered_json numbers(const Vec3& v) { return {v.x, v.y, v.z}; }

/// The crystal's faces, so that every hit can be checked: n . x = offset for the points x of a face.
nlohmann::ordered_json facesJson(const Crystal& crystal) {
  auto json = nlohmann::ordered_json::array();
  const auto& faces = crystal.mesh->faces();
  for (int i = 0; i < static_cast<int>(faces.size()); ++i)
    json.push_back({{"face", faces[i].number}, {"normal", numbers(faces[i].normal)}, {"offset", crystal.offset(i)}});
  return json;
}

/// "3-1-5": the faces met up to an encounter.
std::string raypath(const LightPath& path, int encounter) {
  std::string faces;
  for (int k = encounter; k >= 0; k = path.encounters[k].before)
    faces = std::to_string(path.encounters[k].faceNumber) + (faces.empty() ? "" : "-") + faces;
  return faces;
}

nlohmann::ordered_json sky(const Vec3& lightDirWorld) {
  const SkyPoint point = skyPoint(-lightDirWorld);
  return {{"azimuth_deg", degrees(point.azimuth)}, {"elevation_deg", degrees(point.elevation)}};
}

nlohmann::ordered_json hitJson(const Encounter& hit) {
  nlohmann::ordered_json json;
  const bool leaves = hit.energyLeaving > 0.0, stays = hit.energyStaying > 0.0;
  json["face"] = hit.faceNumber;
  json["point"] = numbers(hit.point);
  json["direction"] = numbers(stays ? hit.stayingDir : hit.leavingDir);
  json["weight"] = hit.energyLeaving;
  json["order"] = hit.order;
  json["leaving_direction"] = leaves ? numbers(hit.leavingDir) : nlohmann::ordered_json();
  json["weight_staying"] = hit.energyStaying;
  return json;
}

nlohmann::ordered_json pathJson(const LightPath& path, const std::string& population) {
  const IncidentRay& ray = path.incident;
  nlohmann::ordered_json json;
  json["ray"] = ray.index;
  json["population"] = population;
  // GLM stores columns; rows read like the matrix on paper.
  json["orientation"] = nlohmann::ordered_json::array();
  for (int row = 0; row < 3; ++row)
    json["orientation"].push_back({ray.crystalToWorld[0][row], ray.crystalToWorld[1][row], ray.crystalToWorld[2][row]});
  json["wavelength"] = ray.light.wavelength;
  json["index"] = ray.iceIndex;
  json["weight"] = ray.weight;
  json["light_direction_world"] = numbers(ray.lightDirWorld);
  json["light_direction"] = numbers(ray.lightDirCrystal);
  json["faces"] = facesJson(ray.crystal);
  json["hits"] = nlohmann::ordered_json::array();
  for (const Encounter& hit : path.encounters) json["hits"].push_back(hitJson(hit));
  json["exits"] = nlohmann::ordered_json::array();
  for (const Exit& exit : path.exits) {
    nlohmann::ordered_json out = sky(exit.lightDirWorld);
    out["raypath"] = raypath(path, exit.encounter);
    out["weight"] = exit.energy;
    out["undeviated"] = exit.undeviated;
    json["exits"].push_back(out);
  }
  return json;
}

void printPath(const LightPath& path, const std::string& population) {
  const IncidentRay& ray = path.incident;
  answer("# ray %llu: population '%s', %.3f nm, n = %.6f", static_cast<unsigned long long>(ray.index),
         population.c_str(), ray.light.wavelength, ray.iceIndex);
  for (int k = 0; k < static_cast<int>(path.encounters.size()); ++k) {
    const Encounter& hit = path.encounters[k];
    // What is outside after a hit may meet a crystal that is not convex again.
    const auto exit = std::ranges::find(path.exits, k, &Exit::encounter);
    const Vec3& dir = hit.energyStaying > 0.0 ? hit.stayingDir : hit.leavingDir;
    std::string leaves;
    if (exit != path.exits.end()) {
      const SkyPoint point = skyPoint(-exit->lightDirWorld);
      char to[80];
      std::snprintf(to, sizeof to, " to azimuth %.4f elevation %.4f by ", degrees(point.azimuth),
                    degrees(point.elevation));
      leaves = to + raypath(path, k) + (exit->undeviated ? " (undeviated)" : "");
    }
    answer("hit %d face %d at (%.6f, %.6f, %.6f) then (%.6f, %.6f, %.6f) leaving %.6g%s", hit.order, hit.faceNumber,
           hit.point.x, hit.point.y, hit.point.z, dir.x, dir.y, dir.z, hit.energyLeaving, leaves.c_str());
  }
}

/// The crystal of a path with its light, in the world. What leaves with less than a hundredth of the light is left out.
CrystalDrawing drawingOf(const LightPath& path, const std::string& population) {
  constexpr double kLeast = 0.01;
  const IncidentRay& ray = path.incident;
  const CrystalMesh& mesh = *ray.crystal.mesh;
  const auto world = [&](const Vec3& v) { return ray.crystalToWorld * v; };
  CrystalDrawing drawing;
  double radius = 0.0;
  for (const Vec3& vertex : mesh.vertices()) {
    const Vec3 stretched(vertex.x, vertex.y, vertex.z * ray.crystal.stretch);
    drawing.vertices.push_back(world(stretched));
    radius = std::max(radius, std::hypot(stretched.x, stretched.y, stretched.z));
  }
  for (const Face& face : mesh.faces())
    for (const std::vector<int>& ring : outlinesOf(face))
      if (!ring.empty()) drawing.faces.push_back({face.number, ring, world(face.normal)});
  for (const Encounter& hit : path.encounters) {
    const Encounter* before = hit.before < 0 ? nullptr : &path.encounters[static_cast<std::size_t>(hit.before)];
    const Vec3 here = world(hit.point);
    const double energy = (hit.energyLeaving + hit.energyStaying) / ray.weight;
    if (energy < kLeast) continue;
    const Vec3 from = before ? world(before->point) : here - radius * ray.lightDirWorld;
    drawing.light.push_back({from, here, energy, before == nullptr});
    if (hit.energyLeaving >= kLeast * ray.weight)
      drawing.light.push_back(
          {here, here + 0.8 * radius * world(hit.leavingDir), hit.energyLeaving / ray.weight, true});
  }
  const auto brightest = std::ranges::max_element(path.exits, {}, &Exit::energy);
  const int last = brightest == path.exits.end() ? 0 : brightest->encounter;
  char light[60];
  std::snprintf(light, sizeof light, ", %.0f nm, n = %.4f: ", ray.light.wavelength, ray.iceIndex);
  drawing.caption =
      "ray " + std::to_string(ray.index) + " of " + population + light + "most light by " + raypath(path, last);
  return drawing;
}

int runReplay(const ReplayOptions& options) {
  Transaction outputs = claimOutputs({{options.scene}, {options.svg}}, options.overwrite);
  const Scene scene = loadSceneOf(options.scene, options.overrides).scene;
  const Cloud cloud = cloudOf(scene);
  const LightPath path = replayRay(scene, cloud, options.ray);
  const std::string& population = cloud.populations()[path.incident.population].name();
  if (options.json)
    answerLines(pathJson(path, population).dump(2) + "\n");
  else
    printPath(path, population);
  if (!options.svg.empty()) drawCrystal(outputs.at(options.svg), drawingOf(path, population), kSoftware);
  outputs.commit();
  return kDone;
}

}  // namespace

void addReplay(CLI::App& app, int& exit) {
  auto options = std::make_shared<ReplayOptions>();
  CLI::App* command = app.add_subcommand(
      "replay", "Print the whole life of one ray: a line a hit, in the crystal's frame, lengths in hexagon sides");
  command->add_option("scene", options->scene, "The scene file")->required()->type_name("SCENE");
  addOverrides(*command, options->overrides);
  command->add_option("--ray", options->ray, "Index of the ray, from 0")
      ->required()
      ->type_name("N")
      ->transform(wholeNumber());
  command->add_flag("--json", options->json, "The same as JSON");
  command->add_option("--svg", options->svg, "Draw the crystal with the ray in it, from the side and from above")
      ->type_name("FILE")
      ->check(fileOfKind({".svg"}, ".svg"));
  addOverwrite(*command, options->overwrite);
  command->callback([options, &exit] { exit = runReplay(*options); });
}

}  // namespace parhelion::cli
