// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>

#include "crystal/crystal.h"
#include "math/random.h"
#include "trace/branch.h"
#include "trace/concave_crystal.h"

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
  ConcaveWalk(const ConcaveCrystal& crystal, double iceIndex, double splitAbove, PathRandom<double> random, Film& film,
              std::vector<ConcaveStep<Mark>>& waiting)
      : crystal_(crystal),
        into_(iceIndex),
        outOf_(RelativeIndex::outOf(iceIndex, 1.0 / iceIndex)),
        splitAbove_(splitAbove),
        random_(random),
        film_(film),
        waiting_(waiting) {}

  double internalPath = 0.0;  // energy-weighted length inside, crystal units
  double cutOff = 0.0, lost = 0.0;
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
    const auto b = branch(step.lightDir, toward, step.cosine, isOutside ? into_ : outOf_, step.energy, splitAbove_,
                          random_.next());
    const Vec3 reflected = renormalised(b.reflectedDir), transmitted = renormalised(b.transmittedDir);
    const Mark mark = film_.meet(step.mark, step);
    const double out = isOutside ? b.reflected : b.transmitted, in = isOutside ? b.transmitted : b.reflected;
    const Vec3& outDir = isOutside ? reflected : transmitted;
    const Vec3& inDir = isOutside ? transmitted : reflected;
    film_.branches(mark, out, outDir, in, inDir);
    if (out > 0.0) goOn(step, mark, Side::outside, outDir, out);
    if (in > 0.0) goOn(step, mark, Side::inside, inDir, in);
  }

  void goOn(const ConcaveStep<Mark>& from, const Mark& mark, Side side, const Vec3& lightDir, double energy) {
    if (side == Side::outside && crystal_.isOnHull(from.face)) return film_.leave(mark, lightDir, energy, from.order);
    if (from.order + 1 >= kMostEncounters) {
      cutOff += energy;
      return;
    }
    const auto hit = crystal_.nextFace(from.point, lightDir, from.face, side);
    if (!hit) {
      if (side == Side::outside) return film_.leave(mark, lightDir, energy, from.order);
      lost += energy;
      return;
    }
    rescued += hit->rescued;
    if (side == Side::inside) internalPath += energy * hit->distance;
    waiting_.push_back(
        {hit->face, from.point + hit->distance * lightDir, lightDir, energy, hit->cosine, from.order + 1, side, mark});
  }

  const ConcaveCrystal& crystal_;
  RelativeIndex into_, outOf_;
  double splitAbove_;
  PathRandom<double> random_;
  Film& film_;
  std::vector<ConcaveStep<Mark>>& waiting_;  // room that is kept from ray to ray
};

}  // namespace parhelion
