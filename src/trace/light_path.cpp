// SPDX-License-Identifier: Apache-2.0
#include "trace/light_path.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "crystal/span.h"
#include "math/random.h"
#include "trace/branch.h"
#include "trace/concave_walk.h"

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
        random_(pathRandom<double>(settings.seed, ray_.bundle)),
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

  /// The outside of the entry face: part of the light is reflected into the sky, part refracted into the crystal.
  void enter() {
    const Vec3& lightDir = ray_.lightDirCrystal;
    const double cosTheta_i = std::max(0.0, -glm::dot(normal(), lightDir));
    const auto branches = branchAt(lightDir, normal(), cosTheta_i, into_);
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
    goOn(hit->distance);
    point_ += hit->distance * lightDir_;
    face_ = hit->face;
    ++order_;

    // The light comes from inside, where the normal does not point.
    const auto branches = branchAt(lightDir_, -normal(), hit->cosine, outOf_);
    lightDir_ = renormalised(branches.reflectedDir);
    energy_ = branches.reflected;
    leave(branches.transmittedDir, branches.transmitted);
  }

  /// The way to the next face.
  void goOn(double distance) {
    if (!ray_.optics.absorbs) {
      path_.internalPath += energy_ * distance;
      return;
    }
    const auto on = attenuated(energy_, ray_.absorption, distance);
    path_.internalPath += on.path;
    path_.absorbed += on.taken;
    energy_ = on.left;
  }

  Branches<double, Vec3> branchAt(const Vec3& lightDir, const Vec3& towardLight, double cosTheta_i,
                                  const RelativeIndex& index) {
    const double u = random_.next();
    if (!(ray_.optics.distortion > 0.0))
      return branch(lightDir, towardLight, cosTheta_i, index, energy_, splitAbove_, u);
    const double u1 = random_.next(), u2 = random_.next();
    return branchAtTilted(lightDir, towardLight, cosTheta_i, index, energy_, splitAbove_, u, ray_.optics, u1, u2);
  }

  /// Direction of light that leaves, where faces spread it.
  Vec3 spread(const Vec3& lightDir) {
    if (!ray_.optics.diffracts) return lightDir;
    FaceRectangle sides = rectangleOf(*ray_.crystal.mesh, face_);
    const double grows = normal().z == 0.0 ? ray_.crystal.stretch : 1.0;
    sides.one.z *= grows;
    sides.other.z *= grows;
    const double u1 = random_.next(), u2 = random_.next();
    return diffracted(lightDir, sides.one, sides.other, ray_.wave, ray_.optics, u1, u2);
  }

  /// Counts the encounter and what leaves the crystal in it.
  void leave(const Vec3& ideal, double energy) {
    const Vec3 leavingDir = spread(ideal);
    ++path_.hits;
    if (path_.recordEncounters)
      path_.encounters.push_back(
          {faces_[face_].number, point_, energy, energy_, leavingDir, lightDir_, order_, order_ - 1});
    if (energy <= 0.0) return;
    const Vec3 world = renormalised(ray_.crystalToWorld * leavingDir);
    path_.exits.push_back({world, energy, order_, isSameDirection<double>(world, ray_.lightDirWorld), order_});
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

/// Puts what becomes of light at crystals of any form into a LightPath. A mark is the place of the last encounter.
class PathFilm {
 public:
  explicit PathFilm(LightPath& path) : path_(path) {}

  int meet(int before, const ConcaveStep<int>& step) {
    if (!path_.recordEncounters) return -1;
    const int number = path_.incident.crystal.mesh->faces()[step.face].number;
    path_.encounters.push_back({number, step.point, 0.0, 0.0, {}, {}, step.order, before});
    return static_cast<int>(path_.encounters.size()) - 1;
  }
  void branches(int mark, double out, const Vec3& outDir, double in, const Vec3& inDir) {
    if (mark < 0) return;
    Encounter& here = path_.encounters[static_cast<std::size_t>(mark)];
    here.energyLeaving = out;
    here.energyStaying = in;
    here.leavingDir = outDir;
    here.stayingDir = inDir;
  }
  void leave(int mark, const Vec3& lightDir, double energy, int order) {
    const IncidentRay& ray = path_.incident;
    const Vec3 world = renormalised(ray.crystalToWorld * lightDir);
    path_.exits.push_back({world, energy, order, isSameDirection<double>(world, ray.lightDirWorld), mark});
  }

 private:
  LightPath& path_;
};

void followConcave(const ConcaveCrystal& crystal, const TraceSettings& settings, LightPath& path) {
  const IncidentRay& ray = path.incident;
  PathFilm film(path);
  std::vector<ConcaveStep<int>> waiting;
  ConcaveWalk walk(crystal, {ray.iceIndex, ray.optics, ray.absorption, ray.wave},
                   ray.weight * pathRule(settings.path).splitShare, pathRandom<double>(settings.seed, ray.bundle), film,
                   waiting);
  walk.run(ray.entry, ray.lightDirCrystal, ray.weight, -1);
  path.internalPath = walk.internalPath;
  path.cutOff = walk.cutOff;
  path.lost = walk.lost;
  path.absorbed = walk.absorbed;
  path.hits = walk.hits;
  path.rescued = walk.rescued;
}

}  // namespace

void followLight(const Intersector& engine, const TraceSettings& settings, LightPath& path) {
  path.exits.clear();
  path.encounters.clear();
  path.internalPath = path.cutOff = path.lost = path.absorbed = 0.0;
  path.hits = path.rescued = 0;
  if (const auto* concave = std::get_if<ConcaveIntersector>(&engine))
    return followConcave(*concave->crystal, settings, path);
  std::visit([&](const auto& chosen) { Walk(chosen, settings, path).run(); }, engine);
}

void followRay(RaySource& source, const Intersectors& engines, const TraceSettings& settings, std::uint64_t index,
               LightPath& path) {
  path.incident = source.ray(index);
  const CrystalMesh& mesh = *path.incident.crystal.mesh;
  // A shape that is spread has no engine of its own; the planes are exact for any convex one.
  if (source.blockOf(path.incident.population)) return followLight(PlanesIntersector(mesh), settings, path);
  followLight(engines[path.incident.population], settings, path);
}

}  // namespace parhelion
