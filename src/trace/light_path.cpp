// SPDX-License-Identifier: Apache-2.0
#include "trace/light_path.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "math/random.h"
#include "optics/interface.h"

namespace parhelion {

namespace {

// A path splits at its faces while it carries at least this share of the ray's light; below, it goes one way as a
// whole, picked by chance. Chosen by variance times time; the mean does not depend on it.
constexpr double kSplitEnergy = 0.5;

// Thin plates and long columns hold light by total reflection for some thousand encounters. What is still inside after
// this many counts as cut off.
constexpr int kMostEncounters = 1'000'000;

// Two directions closer than this (rad) are one: rounding leaves 1e-15 per encounter, and light deviated by less than
// this is none of any halo's.
constexpr double kSameDirection = 1e-8;

/// Walks one path through its crystal, encounter by encounter. A template, so that the engine is chosen once a path.
template <class FaceFinder>
class Walk {
 public:
  Walk(const FaceFinder& engine, const TraceSettings& settings, LightPath& path)
      : engine_(engine),
        ray_(path.incident),
        path_(path),
        splitAbove_(settings.path == PathMode::chance ? std::numeric_limits<double>::infinity() : kSplitEnergy),
        random_(settings.seed, ray_.bundle, RandomPurpose::path) {}

  void run() {
    energy_ = ray_.weight;
    face_ = ray_.entry.face;
    point_ = ray_.entry.point;
    enter();
    while (energy_ > 0.0 && order_ < kMostEncounters) encounter();
    path_.cutOff += energy_;
  }

 private:
  const Vec3& normal() const { return ray_.crystal.mesh->faces()[face_].normal; }

  /// The outside of the entry face: part of the light is reflected into the sky, part refracted into the crystal.
  void enter() {
    const Vec3& lightDir = ray_.lightDirCrystal;
    const double cosTheta_i = std::max(0.0, -glm::dot(normal(), lightDir));
    const Interface face = fresnel(cosTheta_i, ray_.iceIndex);
    const double reflected = split(face.reflectance);
    lightDir_ = glm::normalize(refract(lightDir, normal(), cosTheta_i, face.cosTheta_t, ray_.iceIndex));
    energy_ -= reflected;
    leave(reflect(lightDir, normal(), cosTheta_i), reflected);
  }

  /// The next face met from inside: part of the light leaves, the rest is reflected and goes on.
  void encounter() {
    const auto hit = engine_.nextFace(ray_.crystal, point_, lightDir_, face_);
    if (!hit) {
      path_.lost += std::exchange(energy_, 0.0);
      return;
    }
    path_.rescued += hit->rescued;
    path_.internalPath += energy_ * hit->distance;
    point_ += hit->distance * lightDir_;
    face_ = hit->face;
    ++order_;

    const Vec3 inward = -normal();
    const double cosTheta_i = std::max(0.0, -glm::dot(inward, lightDir_));
    const double eta = 1.0 / ray_.iceIndex;
    const Interface face = fresnel(cosTheta_i, eta);
    const double leaving = energy_ - split(face.reflectance);
    const Vec3 leavingDir = refract(lightDir_, inward, cosTheta_i, face.cosTheta_t, eta);
    lightDir_ = glm::normalize(reflect(lightDir_, inward, cosTheta_i));
    energy_ -= leaving;
    leave(leavingDir, leaving);
  }

  /// How much of the path's energy an interface reflects: its share, or all or nothing by chance. Either way the path
  /// loses no energy and ends without a bias.
  double split(double reflectance) {
    if (energy_ >= splitAbove_) return energy_ * reflectance;
    return random_.next() < reflectance ? energy_ : 0.0;
  }

  /// Counts the encounter and what leaves the crystal in it.
  void leave(const Vec3& leavingDir, double energy) {
    ++path_.hits;
    if (path_.recordEncounters)
      path_.encounters.push_back({ray_.crystal.mesh->faces()[face_].number, point_, energy, energy_,
                                  glm::normalize(leavingDir), lightDir_, order_});
    if (energy <= 0.0) return;
    const Vec3 change = leavingDir - ray_.lightDirCrystal;
    const bool undeviated = glm::dot(change, change) < kSameDirection * kSameDirection;
    path_.exits.push_back({glm::normalize(ray_.crystalToWorld * leavingDir), energy, order_, undeviated});
  }

  const FaceFinder& engine_;
  const IncidentRay& ray_;
  LightPath& path_;
  double splitAbove_;
  RandomStream random_;

  Vec3 point_{}, lightDir_{};  // crystal frame
  double energy_ = 0.0;        // still inside
  int face_ = kNoFace;
  int order_ = 0;
};

}  // namespace

void followLight(const Intersector& engine, const TraceSettings& settings, LightPath& path) {
  path.exits.clear();
  path.encounters.clear();
  path.internalPath = path.cutOff = path.lost = 0.0;
  path.hits = path.rescued = 0;
  std::visit([&](const auto& chosen) { Walk(chosen, settings, path).run(); }, engine);
}

void followRay(const Cloud& cloud, const Engines& engines, const TraceSettings& settings, std::uint64_t index,
               LightPath& path) {
  path.incident = cloud.incidentRay(settings.seed, index);
  followLight(engines[path.incident.population], settings, path);
}

void followBundle(const Cloud& cloud, const Engines& engines, const TraceSettings& settings, std::uint64_t bundle,
                  std::vector<LightPath>& paths) {
  const std::uint64_t size = cloud.bundleSize(), first = bundle * size;
  paths.resize(std::min(size, settings.rays - first));
  followRay(cloud, engines, settings, first, paths[0]);
  for (std::uint64_t k = 1; k < paths.size(); ++k) {
    paths[k].incident = cloud.sibling(paths[0].incident, settings.seed, first + k);
    followLight(engines[paths[k].incident.population], settings, paths[k]);
  }
}

}  // namespace parhelion
