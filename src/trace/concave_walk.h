// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>

#include "crystal/crystal.h"
#include "crystal/span.h"
#include "math/random.h"
#include "trace/branch.h"
#include "trace/concave_crystal.h"
#include "trace/crystal_optics.h"

namespace parhelion {

/// Light of one ray on its way to its next face of a crystal of any form.
template <class Mark>
struct ConcaveStep {
  int face;  // that it meets next
  Vec3 point, lightDir;
  double energy, cosine;  // of lightDir and the normal, > 0
  int order;              // encounters before
  Side side;              // that it comes from
  Mark mark;
};

/// What a crystal is to one ray: see IncidentRay.
struct RayOptics {
  double iceIndex;
  const CrystalOptics& crystal;
  double absorption, wave;
};

/// Follows one ray that meets a crystal of any form until all of its light has met nothing more. At each face one part
/// goes on inside, one outside; who leaves to the outside may meet the crystal again. The parts are followed one after
/// another, the last that has come up first.
///
/// `Film` takes what becomes of it; a Mark is what it keeps of each way:
///   Mark meet(const Mark&, const ConcaveStep<Mark>&)   one encounter more
///   void branches(const Mark&, out, outDir, in, inDir) of that encounter: energy and direction on both sides
///   void leave(const Mark&, const Vec3& lightDir, double energy, int order)
template <class Mark, class Film>
class ConcaveWalk {
 public:
  ConcaveWalk(const ConcaveCrystal& crystal, const RayOptics& optics, double splitAbove, PathRandom<double> random,
              Film& film, std::vector<ConcaveStep<Mark>>& waiting)
      : crystal_(crystal),
        optics_(optics),
        into_(optics.iceIndex),
        outOf_(RelativeIndex::outOf(optics.iceIndex, 1.0 / optics.iceIndex)),
        splitAbove_(splitAbove),
        random_(random),
        film_(film),
        waiting_(waiting) {}

  double internalPath = 0.0;  // energy-weighted length inside, crystal units
  double cutOff = 0.0, lost = 0.0, absorbed = 0.0;
  int hits = 0, rescued = 0;

  void run(const EntryPoint& entry, const Vec3& lightDir, double energy, const Mark& start) {
    const double cosine = std::max(0.0, -glm::dot(crystal_.mesh().faces()[entry.face].normal, lightDir));
    waiting_.assign(1, {entry.face, entry.point, lightDir, energy, cosine, 0, Side::outside, start});
    while (!waiting_.empty()) {
      const ConcaveStep<Mark> step = waiting_.back();
      waiting_.pop_back();
      meet(step);
    }
  }

 private:
  void meet(const ConcaveStep<Mark>& step) {
    ++hits;
    const bool isOutside = step.side == Side::outside;
    const Vec3 normal = crystal_.mesh().faces()[step.face].normal, toward = isOutside ? normal : -normal;
    const auto b = branchAt(step, toward, isOutside ? into_ : outOf_);
    const Vec3 reflected = renormalised(b.reflectedDir), transmitted = renormalised(b.transmittedDir);
    const Mark mark = film_.meet(step.mark, step);
    const double out = isOutside ? b.reflected : b.transmitted, in = isOutside ? b.transmitted : b.reflected;
    const Vec3& outDir = isOutside ? reflected : transmitted;
    const Vec3& inDir = isOutside ? transmitted : reflected;
    film_.branches(mark, out, outDir, in, inDir);
    if (out > 0.0) goOn(step, mark, Side::outside, outDir, out);
    if (in > 0.0) goOn(step, mark, Side::inside, inDir, in);
  }

  Branches<double, Vec3> branchAt(const ConcaveStep<Mark>& step, const Vec3& toward, const RelativeIndex& index) {
    const double u = random_.next();
    if (!(optics_.crystal.distortion > 0.0))
      return branch(step.lightDir, toward, step.cosine, index, step.energy, splitAbove_, u);
    const double u1 = random_.next(), u2 = random_.next();
    return branchAtTilted(step.lightDir, toward, step.cosine, index, step.energy, splitAbove_, u, optics_.crystal, u1,
                          u2);
  }

  void leave(const ConcaveStep<Mark>& from, const Mark& mark, const Vec3& lightDir, double energy) {
    if (!optics_.crystal.diffracts) return film_.leave(mark, lightDir, energy, from.order);
    const FaceRectangle sides = rectangleOf(crystal_.mesh(), from.face);
    const double u1 = random_.next(), u2 = random_.next();
    film_.leave(mark, diffracted(lightDir, sides.one, sides.other, optics_.wave, optics_.crystal, u1, u2), energy,
                from.order);
  }

  void goOn(const ConcaveStep<Mark>& from, const Mark& mark, Side side, const Vec3& lightDir, double energy) {
    if (side == Side::outside && crystal_.isOnHull(from.face)) return leave(from, mark, lightDir, energy);
    if (from.order + 1 >= kMostEncounters) {
      cutOff += energy;
      return;
    }
    const auto hit = crystal_.nextFace(from.point, lightDir, from.face, side);
    if (!hit) {
      if (side == Side::outside) return leave(from, mark, lightDir, energy);
      lost += energy;
      return;
    }
    rescued += hit->rescued;
    if (side == Side::inside && optics_.crystal.absorbs) {
      const auto on = attenuated(energy, optics_.absorption, hit->distance);
      internalPath += on.path;
      absorbed += on.taken;
      energy = on.left;
      if (!(energy > 0.0)) return;
    } else if (side == Side::inside) {
      internalPath += energy * hit->distance;
    }
    waiting_.push_back(
        {hit->face, from.point + hit->distance * lightDir, lightDir, energy, hit->cosine, from.order + 1, side, mark});
  }

  const ConcaveCrystal& crystal_;
  RayOptics optics_;
  RelativeIndex into_, outOf_;
  double splitAbove_;
  PathRandom<double> random_;
  Film& film_;
  std::vector<ConcaveStep<Mark>>& waiting_;  // room that is kept from ray to ray
};

}  // namespace parhelion
