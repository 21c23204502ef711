// SPDX-License-Identifier: Apache-2.0
#include "trace/light_path.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "math/random.h"
#include "optics/interface.h"
#include "trace/path_rule.h"

namespace parhelion {

namespace {

/// Walks one path through its crystal, encounter by encounter. A template, so that the engine is chosen once a path.
template <class FaceFinder>
class Walk {
 public:
  Walk(const FaceFinder& engine, const TraceSettings& settings, LightPath& path)
      : engine_(engine),
        ray_(path.incident),
        faces_(ray_.crystal.mesh->faces().data()),
        path_(path),
        splitAbove_(ray_.weight * pathRule(settings.path).splitShare),
        random_(pathRandom(settings.seed, ray_.bundle)),
        into_(ray_.iceIndex),
        outOf_(RelativeIndex::outOf(ray_.iceIndex, 1.0 / ray_.iceIndex)) {}

  void run() {
    energy_ = ray_.weight;
    face_ = ray_.entry.face;
    point_ = ray_.entry.point;
    enter();
    while (energy_ > 0.0 && order_ < kMostEncounters) encounter();
    path_.cutOff += energy_;
  }

 private:
  const Vec3& normal() const { return faces_[face_].normal; }

  /// What an interface makes of the light that meets it.
  struct Branches {
    double reflected = 0.0, transmitted = 0.0;  // energy
    Vec3 reflectedDir{}, transmittedDir{};      // unit, crystal frame; only of what carries energy
  };

  /// The branches at a face of outward normal * `side` on the side the light comes from. Each carries its share of the
  /// path's energy, or one carries all of it by chance. Either way no energy is lost, and paths end without a bias.
  Branches meet(const Vec3& lightDir, double side, double cosTheta_i, const RelativeIndex& index) {
    const Interface face = fresnel(cosTheta_i, index);
    Branches branches;
    const double random = random_.next();
    if (energy_ >= splitAbove_)
      branches.reflected = energy_ * face.reflectance;
    else if (random < face.reflectance)
      branches.reflected = energy_;
    branches.transmitted = energy_ - branches.reflected;
    const Vec3 towardLight = side * normal();
    if (branches.reflected > 0.0) branches.reflectedDir = reflect(lightDir, towardLight, cosTheta_i);
    if (branches.transmitted > 0.0)
      branches.transmittedDir = refract(lightDir, towardLight, cosTheta_i, face.cosTheta_t, index);
    return branches;
  }

  /// The outside of the entry face: part of the light is reflected into the sky, part refracted into the crystal.
  void enter() {
    const Vec3& lightDir = ray_.lightDirCrystal;
    const double cosTheta_i = std::max(0.0, -glm::dot(normal(), lightDir));
    const Branches branches = meet(lightDir, 1.0, cosTheta_i, into_);
    lightDir_ = renormalised(branches.transmittedDir);
    energy_ = branches.transmitted;
    leave(branches.reflectedDir, branches.reflected);
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

    const Branches branches = meet(lightDir_, -1.0, hit->cosine, outOf_);
    lightDir_ = renormalised(branches.reflectedDir);
    energy_ = branches.reflected;
    leave(branches.transmittedDir, branches.transmitted);
  }

  /// Counts the encounter and what leaves the crystal in it.
  void leave(const Vec3& leavingDir, double energy) {
    ++path_.hits;
    if (path_.recordEncounters)
      path_.encounters.push_back({faces_[face_].number, point_, energy, energy_, leavingDir, lightDir_, order_});
    if (energy <= 0.0) return;
    const Vec3 world = renormalised(ray_.crystalToWorld * leavingDir), change = world - ray_.lightDirWorld;
    const bool undeviated = glm::dot(change, change) < kSameDirection * kSameDirection;
    path_.exits.push_back({world, energy, order_, undeviated});
  }

  const FaceFinder& engine_;
  const IncidentRay& ray_;
  const Face* faces_;
  LightPath& path_;
  double splitAbove_;
  PathRandom<double> random_;

  RelativeIndex into_, outOf_;

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

void followRay(RaySource& source, const Engines& engines, const TraceSettings& settings, std::uint64_t index,
               LightPath& path) {
  path.incident = source.ray(index);
  followLight(engines[path.incident.population], settings, path);
}

}  // namespace parhelion
