// SPDX-License-Identifier: Apache-2.0
#pragma once

// Part of lane_code.cpp, and of nothing else.

#include "trace/branch.h"
#include "trace/crystal_optics.h"
#include "trace/face_hit.h"
#include "trace/lane_types.h"

namespace parhelion {
namespace {

/// Sums of energies in whole units, so that the order leaves no trace.
class UnitSum {
 public:
  explicit UnitSum(double perLight) : perLight_(perLight) {}

  PARHELION_INLINE void add(const Real& energy) {
    // Behind 1.5 * 2^52 a number's last bit is a unit, for up to 2^51 of them.
    constexpr double kShift = 0x1.8p52;
    sum_ += bitsAs<Mask>(energy * perLight_ + kShift) - bitsAs<Mask>(Real{} + kShift);
  }
  std::int64_t total() const {
    std::int64_t total = 0;
    for (int k = 0; k < kLanes; ++k) total += sum_[k];
    return total;
  }

 private:
  double perLight_;
  Mask sum_{};
};

/// What is kept of the faces that rays have met, in each lane; `kRecord` says which of it.
template <PathRecord kRecord>
struct PathMet {
  Real state{};
  Words first{}, last{};

  PARHELION_INLINE void load(const RayPool& pool, int i) {
    state = parhelion::load<Real>(&pool.pathState[i]);
    if constexpr (kRecord != PathRecord::sequence) return;
    first = parhelion::load<Words>(&pool.pathFirst[i]);
    last = parhelion::load<Words>(&pool.pathLast[i]);
  }
  PARHELION_INLINE void store(RayPool& pool, int i) const {
    parhelion::store(&pool.pathState[i], state);
    if constexpr (kRecord != PathRecord::sequence) return;
    parhelion::store(&pool.pathFirst[i], first);
    parhelion::store(&pool.pathLast[i], last);
  }

  /// One face more, the one at `place` of the path.
  PARHELION_INLINE void add(const PathTable& paths, const Real& face, const Real& place) {
    if constexpr (kRecord == PathRecord::nothing) return;
    state = lookUp(paths.next, state * paths.faces + face);
    if constexpr (kRecord == PathRecord::sequence) {
      const Words code = wordsOf(face);
      const Words shifted = code << wordsOf(place * static_cast<double>(paths.bits));
      const Mask hasRoom = place < static_cast<double>(paths.room);
      first |= bitsAs<Words>(select(hasRoom, bitsAs<Real>(shifted), Real{}));
      last = last << paths.bits | code;
    }
  }

 private:
  /// Whole numbers from 0 to 2^51 as integers.
  PARHELION_INLINE static Words wordsOf(const Real& whole) {
    constexpr std::uint64_t kDigits = (std::uint64_t{1} << 52) - 1;
    return bitsAs<Words>(whole + 0x1p52) & kDigits;
  }
};

/// Puts the lanes of light that leaves on the list.
template <PathRecord kRecord>
PARHELION_INLINE void leave(const Triple<Real>& direction, const Real& energy, const Real& ray, const Real& order,
                            const PathMet<kRecord>& path, ExitList& exits) {
  const Compress<Real> leaving(energy > 0.0);
  leaving.store(&exits.lightDirCrystal[0][exits.count], direction.x);
  leaving.store(&exits.lightDirCrystal[1][exits.count], direction.y);
  leaving.store(&exits.lightDirCrystal[2][exits.count], direction.z);
  leaving.store(&exits.energy[exits.count], energy);
  leaving.store(&exits.ray[exits.count], ray);
  leaving.store(&exits.order[exits.count], order);
  if constexpr (kRecord != PathRecord::nothing) leaving.store(&exits.pathState[exits.count], path.state);
  if constexpr (kRecord == PathRecord::sequence) {
    leaving.store(&exits.pathFirst[exits.count], bitsAs<Real>(path.first));
    leaving.store(&exits.pathLast[exits.count], bitsAs<Real>(path.last));
  }
  exits.count += leaving.count();
}

/// Direction of light that leaves by a face, where faces spread it.
PARHELION_INLINE Triple<Real> spread(const FaceTable& faces, const CrystalOptics& optics, const Real& face,
                                     const Real& stretch, const Real& wave, const Triple<Real>& lightDir,
                                     PathRandom<Real>& random) {
  Triple<Real> one = lookUpTriple(faces.sideOne, face), other = lookUpTriple(faces.sideOther, face);
  const Real grows = select(normalOf(faces, face).z == 0.0, stretch, all<Real>(1.0));
  one.z *= grows;
  other.z *= grows;
  const Real u1 = random.next(), u2 = random.next();
  return diffracted(lightDir, one, other, wave, optics, u1, u2);
}

/// branch(), of faces that may be tilted by chance.
template <bool kReal>
PARHELION_INLINE Branches<Real, Triple<Real>> branchAt(const CrystalOptics& optics, const Triple<Real>& lightDir,
                                                       const Triple<Real>& towardLight, const Real& cosTheta_i,
                                                       const RelativeIndexOf<Real>& index, const Real& energy,
                                                       const Real& splitAbove, PathRandom<Real>& random) {
  const Real u = random.next();
  if (kReal && optics.distortion > 0.0) {
    const Real u1 = random.next(), u2 = random.next();
    return branchAtTilted(lightDir, towardLight, cosTheta_i, index, energy, splitAbove, u, optics, u1, u2);
  }
  return branch(lightDir, towardLight, cosTheta_i, index, energy, splitAbove, u);
}

template <PathRecord kRecord, bool kReal>
void enter(const FaceTable& faces, const CrystalOptics& optics, const PathTable& paths, std::uint64_t seed,
           PathRule rule, int member, RayQueue& queue, ExitList& exits, EnergyUnits& energy) {
  UnitSum out(energy.perLight);
  for (int i = 0; i < queue.count; i += kLanes) {
    const int ray = queue.ray(member, i);
    const Mask real = below(i, queue.count);
    const Triple<Real> light = loadTriple(queue.lightCrystal, i);
    const Real face = load<Real>(&queue.face[i]), weight = load<Real>(&queue.weight[i]);
    const Triple<Real> normal = normalOf(faces, face);
    const Real cosTheta_i = higher(-dot(normal, light), Real{});
    const RelativeIndexOf<Real> index(load<Real>(&queue.iceIndex[ray]));
    auto random = pathRandom<Real>(seed, load<Words>(&queue.bundle[i]));
    auto b = branchAt<kReal>(optics, light, normal, cosTheta_i, index, weight, weight * rule.splitShare, random);
    if (kReal && optics.diffracts)
      b.reflectedDir = spread(faces, optics, face, load<Real>(&queue.stretch[i]), load<Real>(&queue.wave[ray]),
                              b.reflectedDir, random);

    store(&queue.energy[ray], b.transmitted);
    storeTriple(queue.inside, ray, renormalised(b.transmittedDir));
    store(&queue.random0[i], random.state0);
    store(&queue.random1[i], random.state1);
    const Real reflected = select(real, b.reflected, Real{});
    out.add(reflected);
    PathMet<kRecord> path;
    path.add(paths, face, Real{});
    leave(b.reflectedDir, reflected, counting() + static_cast<double>(ray), Real{}, path, exits);
  }
  energy.out += out.total();
}

void findFaces(const SlabTable& slabs, RayPool& pool) {
  for (int i = 0; i < pool.active; i += kLanes) {
    const FaceMet<Real> met = slabs.next(loadTriple(pool.point, i), loadTriple(pool.lightDir, i),
                                         load<Real>(&pool.stretch[i]), load<Real>(&pool.face[i]));
    store(&pool.nextFace[i], met.face);
    store(&pool.distance[i], met.distance);
    store(&pool.cosine[i], met.cosine);
  }
}

void measureFaces(const FaceTable& faces, RayPool& pool) {
  for (int i = 0; i < pool.active; i += kLanes) {
    const Real named = load<Real>(&pool.nextFace[i]), face = higher(named, Real{});
    const Triple<Real> normal = normalOf(faces, face);
    const Real approach = dot(normal, loadTriple(pool.lightDir, i)), height = dot(normal, loadTriple(pool.point, i));
    const Real offset = lookUp(faces.offset.data(), face);
    const Real gap = select(normal.z == 0.0, offset, offset * load<Real>(&pool.stretch[i])) - height;
    // In single precision a ray along an edge may meet a face from outside; such a hit is no way out.
    store(&pool.nextFace[i], select(approach > 0.0, named, all<Real>(kNoFace)));
    store(&pool.distance[i], higher(gap / approach, Real{}));
    store(&pool.cosine[i], approach);
  }
}

/// One encounter of the rays from place i on; returns those whose path ends here.
template <PathRecord kRecord, bool kReal>
PARHELION_INLINE Mask meetFace(const FaceTable& faces, const CrystalOptics& optics, const PathTable& paths, int i,
                               RayPool& pool, ExitList& exits, UnitSum& out) {
  const Triple<Real> light = loadTriple(pool.lightDir, i);
  const Real face = higher(load<Real>(&pool.nextFace[i]), Real{}), cosine = load<Real>(&pool.cosine[i]);
  const Real distance = load<Real>(&pool.distance[i]);
  Real energy = load<Real>(&pool.energy[i]), pathInside = energy * distance;
  if (kReal && optics.absorbs) {
    const auto on = attenuated(energy, load<Real>(&pool.absorption[i]), distance);
    store(&pool.absorbed[i], load<Real>(&pool.absorbed[i]) + on.taken);
    energy = on.left;
    pathInside = on.path;
  }
  const Real order = load<Real>(&pool.order[i]) + 1.0;
  store(&pool.internalPath[i], load<Real>(&pool.internalPath[i]) + pathInside);
  storeTriple(pool.point, i, loadTriple(pool.point, i) + distance * light);
  store(&pool.face[i], face);
  store(&pool.order[i], order);

  PathRandom<Real> random{load<Words>(&pool.random0[i]), load<Words>(&pool.random1[i])};
  const auto index = RelativeIndexOf<Real>::outOf(load<Real>(&pool.iceIndex[i]), load<Real>(&pool.perIceIndex[i]));
  // The light comes from inside, where the normal does not point.
  auto b = branchAt<kReal>(optics, light, -normalOf(faces, face), cosine, index, energy,
                           load<Real>(&pool.splitAbove[i]), random);
  if (kReal && optics.diffracts)
    b.transmittedDir =
        spread(faces, optics, face, load<Real>(&pool.stretch[i]), load<Real>(&pool.wave[i]), b.transmittedDir, random);
  store(&pool.random0[i], random.state0);
  store(&pool.random1[i], random.state1);

  PathMet<kRecord> path;
  if constexpr (kRecord != PathRecord::nothing) {
    path.load(pool, i);
    path.add(paths, face, order);
    path.store(pool, i);
  }

  out.add(b.transmitted);
  leave(b.transmittedDir, b.transmitted, load<Real>(&pool.ray[i]), order, path, exits);
  storeTriple(pool.lightDir, i, renormalised(b.reflectedDir));
  store(&pool.energy[i], b.reflected);
  return (b.reflected <= 0.0) | (order >= static_cast<double>(kMostEncounters));
}

/// Takes the light of rays for which no face was found.
PARHELION_INLINE void loseLight(int i, RayPool& pool, UnitSum& lost, EnergyUnits& energy) {
  const Mask none = (load<Real>(&pool.nextFace[i]) < 0.0) & below(i, pool.active);
  if (__builtin_expect(!anyOf(none), true)) return;
  const Real light = load<Real>(&pool.energy[i]);
  store(&pool.lost[i], select(none, light, Real{}));
  lost.add(select(none, light, Real{}));
  store(&pool.energy[i], select(none, Real{}, light));
  store(&pool.distance[i], select(none, Real{}, load<Real>(&pool.distance[i])));
  energy.lostPaths += __builtin_popcount(bitsOf(none));
}

template <PathRecord kRecord, bool kReal>
void meetFaces(const FaceTable& faces, const CrystalOptics& optics, const PathTable& paths, RayPool& pool,
               ExitList& exits, EnergyUnits& energy) {
  UnitSum out(energy.perLight), lost(energy.perLight);
  pool.endedCount = 0;
  for (int i = 0; i < pool.active; i += kLanes) {
    loseLight(i, pool, lost, energy);
    const Compress<Real> ended(meetFace<kRecord, kReal>(faces, optics, paths, i, pool, exits, out) &
                               below(i, pool.active));
    ended.store(&pool.ended[pool.endedCount], counting() + static_cast<double>(i));
    pool.endedCount += ended.count();
  }
  energy.out += out.total();
  energy.lost += lost.total();
}

}  // namespace
}  // namespace parhelion
