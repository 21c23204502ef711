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

// Reflections keep a direction's length but for rounding; so many in a row put it off by less than 1e-14.
constexpr int kRenormalise = 16;

/// A vector that rounding alone has put off its length of 1, brought back to it: one step of Newton's method for
/// 1 / sqrt leaves the square of the error.
Vec3 renormalised(const Vec3& v) { return v * (1.5 - 0.5 * glm::dot(v, v)); }

/// Walks one path through its crystal, encounter by encounter. A template, so that the engine is chosen once a path.
template <class FaceFinder>
class Walk {
 public:
  Walk(const FaceFinder& engine, const TraceSettings& settings, LightPath& path)
      : engine_(engine),
        ray_(path.incident),
        faces_(ray_.crystal.mesh->faces().data()),
        path_(path),
        splitAbove_(settings.path == PathMode::chance ? std::numeric_limits<double>::infinity() : kSplitEnergy),
        random_(settings.seed, ray_.bundle, RandomPurpose::path),
        into_(ray_.iceIndex),
        outOf_(1.0 / ray_.iceIndex) {}

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
    if (energy_ >= splitAbove_)
      branches.reflected = energy_ * face.reflectance;
    else if (random_.next() < face.reflectance)
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
    lightDir_ = order_ % kRenormalise == 0 ? renormalised(branches.reflectedDir) : branches.reflectedDir;
    energy_ = branches.reflected;
    leave(branches.transmittedDir, branches.transmitted);
  }

  /// Counts the encounter and what leaves the crystal in it.
  void leave(const Vec3& leavingDir, double energy) {
    ++path_.hits;
    if (path_.recordEncounters)
      path_.encounters.push_back({faces_[face_].number, point_, energy, energy_, leavingDir, lightDir_, order_});
    if (energy <= 0.0) return;
    const Vec3 change = leavingDir - ray_.lightDirCrystal;
    const bool undeviated = glm::dot(change, change) < kSameDirection * kSameDirection;
    path_.exits.push_back({renormalised(ray_.crystalToWorld * leavingDir), energy, order_, undeviated});
  }

  const FaceFinder& engine_;
  const IncidentRay& ray_;
  const Face* faces_;
  LightPath& path_;
  double splitAbove_;
  RandomStream random_;

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
