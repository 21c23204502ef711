// SPDX-License-Identifier: Apache-2.0
// Compiled once for each set of vector registers, with PARHELION_LANES doubles side by side. Nothing here may be shared
// with code for other registers: everything is local to the file, inlined, or a template of this file's lanes.
#include "math/lanes.h"
#include "optics/interface.h"
#include "trace/kernels.h"

namespace parhelion {
namespace {

constexpr int kLanes = PARHELION_LANES;
using Real = Lanes<kLanes>::Real;
using Mask = Lanes<kLanes>::Mask;
using Words = Lanes<kLanes>::Words;

/// 0, 1, 2, ...
PARHELION_INLINE Real counting() {
  Real lanes;
  for (int k = 0; k < kLanes; ++k) lanes[k] = k;
  return lanes;
}

/// The lanes from place i on that are below `end`.
PARHELION_INLINE Mask below(int i, int end) { return counting() < static_cast<double>(end - i); }

PARHELION_INLINE Triple<Real> loadTriple(const RayQueue::Row* rows, int i) {
  return {load<Real>(&rows[0][i]), load<Real>(&rows[1][i]), load<Real>(&rows[2][i])};
}
PARHELION_INLINE Triple<Real> loadTriple(const RayPool::Numbers* rows, int i) {
  return {load<Real>(&rows[0][i]), load<Real>(&rows[1][i]), load<Real>(&rows[2][i])};
}
template <class Rows>
PARHELION_INLINE void storeTriple(Rows* rows, int i, const Triple<Real>& v) {
  store(&rows[0][i], v.x);
  store(&rows[1][i], v.y);
  store(&rows[2][i], v.z);
}

PARHELION_INLINE Triple<Real> normalOf(const FaceTable& faces, const Real& face) {
  return {lookUp(faces.x.data(), face), lookUp(faces.y.data(), face), lookUp(faces.z.data(), face)};
}

/// Philox4x32-10 as philox4x32() of math/random.h has it, one counter a lane; the halves above 32 bits are rubbish
/// until the end.
struct PhiloxWords {
  Words a, b, c, d;
};
PARHELION_INLINE PhiloxWords philox(Words a, Words b, Words c, Words d, std::uint64_t seed) {
  std::uint32_t key0 = static_cast<std::uint32_t>(seed), key1 = static_cast<std::uint32_t>(seed >> 32);
  for (int round = 0; round < 10; ++round) {
    const Words product0 = product32(a, 0xD2511F53), product1 = product32(c, 0xCD9E8D57);
    a = (product1 >> 32) ^ b ^ key0;
    b = product1;
    c = (product0 >> 32) ^ d ^ key1;
    d = product0;
    key0 += 0x9E3779B9;
    key1 += 0xBB67AE85;
  }
  return {a, b, c, d};
}

/// Two words of 64 bits from a block.
struct RandomWords {
  Words first, second;
};
PARHELION_INLINE RandomWords randomWords(std::uint64_t seed, RandomPurpose purpose, std::uint32_t block,
                                         const Words& bundle) {
  const Words zero{};
  const PhiloxWords w =
      philox(zero + std::uint64_t{block}, zero + static_cast<std::uint64_t>(purpose), bundle, bundle >> 32, seed);
  constexpr std::uint64_t kLow = 0xFFFFFFFF;
  return {(w.b << 32) | (w.a & kLow), (w.d << 32) | (w.c & kLow)};
}

void draw(std::uint64_t seed, RandomPurpose purpose, const std::uint64_t* bundle, int count, std::uint32_t firstBlock,
          int blocks, IncidenceNumbers& numbers) {
  for (int b = 0; b < blocks; ++b) {
    double* first = numbers.row[2 * b].data();
    double* second = numbers.row[2 * b + 1].data();
    for (int i = 0; i < count; i += kLanes) {
      const RandomWords words = randomWords(seed, purpose, firstBlock + b, load<Words>(bundle + i));
      store(first + i, toUnitInterval<Real>(words.first));
      store(second + i, toUnitInterval<Real>(words.second));
    }
  }
}

/// The shadows that a crystal's lit faces cast on a plane across the light.
struct ShadowLanes {
  Real face[kMaxFaces];
  Real total;
};
PARHELION_INLINE void castShadows(const FaceTable& faces, const Triple<Real>& light, const Real& stretch,
                                  ShadowLanes& shadows) {
  shadows.total = Real{};
  for (int f = 0; f < faces.faces; ++f) {
    const Real cosine = -(faces.x[f] * light.x + faces.y[f] * light.y + faces.z[f] * light.z);
    const Real area = faces.areaGrows[f] != 0.0 ? faces.area[f] * stretch : all<Real>(faces.area[f]);
    shadows.face[f] = higher(cosine, Real{}) * area;
    shadows.total += shadows.face[f];
  }
}

/// Where light first meets a crystal.
struct EntryLanes {
  Real face;
  Triple<Real> point;
};

/// A lit face, picked in proportion to its shadow.
PARHELION_INLINE Real litFace(const FaceTable& faces, const ShadowLanes& shadows, const Real& u) {
  Real left = u * shadows.total, face{};
  Mask found{};
  for (int f = 0; f < faces.faces; ++f) {
    const Mask open = ~found & (shadows.face[f] > 0.0), here = open & (left < shadows.face[f]);
    face = select(open, all<Real>(f), face);
    left = select(open, left - shadows.face[f], left);
    found |= here;
  }
  return face;
}

/// A uniform point of a face: a triangle of its fan by area, then a point in the triangle.
PARHELION_INLINE Triple<Real> pointOnFace(const FaceTable& faces, const Real& face, const Real& u1, const Real& u2) {
  Real left = u1 * lookUp(faces.area.data(), face), triangle = face * static_cast<double>(faces.fan);
  Mask on = ~Mask{};
  for (int j = 0; j + 1 < faces.fan; ++j) {
    const Real limit = lookUp(faces.triangleLimit.data(), triangle);
    on &= left > limit;
    left = select(on, left - limit, left);
    triangle = select(on, triangle + 1.0, triangle);
  }
  // What is left of u1 is uniform again; the square root makes the triangle uniform.
  const Real s = squareRoot(lower(left / lookUp(faces.triangleArea.data(), triangle), all<Real>(1.0)));
  const Real alongB = s * (1.0 - u2), alongC = s * u2;
  const auto at = [&](const std::vector<double>& corner, const std::vector<double>& ab, const std::vector<double>& ac) {
    return lookUp(corner.data(), triangle) + alongB * lookUp(ab.data(), triangle) +
           alongC * lookUp(ac.data(), triangle);
  };
  return {at(faces.cornerX, faces.abX, faces.acX), at(faces.cornerY, faces.abY, faces.acY),
          at(faces.cornerZ, faces.abZ, faces.acZ)};
}

void propose(const IncidenceTable& table, const IncidenceNumbers& numbers, Proposals& proposals, RayQueue& queue) {
  const FaceTable& faces = *table.faces;
  ShadowLanes shadows;
  const auto u = [&](IncidenceNumber what, int i) { return load<Real>(&numbers.row[what][i]); };
  const auto put = [&](const Compress<Real>& taken, RayQueue::Row* rows, const Triple<Real>& v) {
    taken.store(&rows[0][queue.count], v.x);
    taken.store(&rows[1][queue.count], v.y);
    taken.store(&rows[2][queue.count], v.z);
  };
  for (int i = 0; i < proposals.count; i += kLanes) {
    const auto axes = table.orientation.at(u(kZenith, i), u(kAzimuth, i), u(kRoll, i));
    const Real stretch = table.stretch ? table.stretch->at(u(kStretch, i)) : all<Real>(1.0);
    Triple<Real> toSun{all<Real>(table.toSun.x), all<Real>(table.toSun.y), all<Real>(table.toSun.z)};
    if (table.sunDisc) toSun = table.sunDisc->toPoint(u(kSunRadius, i), u(kSunAngle, i));
    const Triple<Real> world{-toSun.x, -toSun.y, -toSun.z};
    const Triple<Real> light{dot(axes.x, world), dot(axes.y, world), dot(axes.z, world)};

    castShadows(faces, light, stretch, shadows);
    const Real ratio = shadows.total / (faces.surfaceAcrossC + faces.surfaceAlongC * stretch) / table.bound;
    const Mask real = below(i, proposals.count);
    const Mask take = table.rejects ? real & (u(kAcceptance, i) < ratio) : real;
    const Real weight = table.rejects ? higher(ratio, all<Real>(1.0)) : ratio;
    const Real face = litFace(faces, shadows, u(kEntryFace, i));
    Triple<Real> point = pointOnFace(faces, face, u(kEntryS, i), u(kEntryT, i));
    point.z *= stretch;

    const Compress<Real> taken(take), rejected(real & ~take);
    const Real bundle = load<Real>(proposals.bundle + i);
    taken.store(&queue.bundle[queue.count], bundle);
    put(taken, queue.crystalX, axes.x);
    put(taken, queue.crystalY, axes.y);
    put(taken, queue.crystalZ, axes.z);
    put(taken, queue.lightWorld, world);
    put(taken, queue.lightCrystal, light);
    put(taken, queue.point, point);
    taken.store(&queue.face[queue.count], face);
    taken.store(&queue.stretch[queue.count], stretch);
    taken.store(&queue.shadow[queue.count], shadows.total);
    taken.store(&queue.weight[queue.count], weight);
    queue.count += taken.count();
    rejected.store(proposals.rejected + proposals.rejectedCount, bundle);
    proposals.rejectedCount += rejected.count();
  }
}

/// What an interface makes of the light that meets it.
struct BranchLanes {
  Real reflected, transmitted;  // energy
  Real cosTheta_t;
};

/// Each branch carries its share of the light, or one carries all of it by chance. Either way no energy is lost, and
/// paths end without a bias.
PARHELION_INLINE BranchLanes branch(const Real& energy, const Real& splitAbove, const Real& random,
                                    const Real& cosTheta_i, const RelativeIndexOf<Real>& index) {
  const InterfaceOf<Real> face = fresnel(cosTheta_i, index);
  const Real whole = select(random < face.reflectance, energy, Real{});
  const Real reflected = select(energy >= splitAbove, energy * face.reflectance, whole);
  return {reflected, energy - reflected, face.cosTheta_t};
}

/// Sums of energies as whole units, so that the order leaves no trace.
class UnitSum {
 public:
  PARHELION_INLINE void add(const Real& energy) {
    // Behind 1.5 * 2^52 a number's last bit is a unit; energies are far below 2^11.
    constexpr double kShift = 0x1.8p52;
    sum_ += bitsAs<Mask>(energy * 0x1p40 + kShift) - bitsAs<Mask>(Real{} + kShift);
  }
  std::int64_t total() const {
    std::int64_t total = 0;
    for (int k = 0; k < kLanes; ++k) total += sum_[k];
    return total;
  }

 private:
  Mask sum_{};
};

/// Puts the lanes of light that leaves on the list.
PARHELION_INLINE void leave(const Triple<Real>& direction, const Real& energy, const Real& ray, const Real& order,
                            ExitList& exits) {
  const Compress<Real> leaving(energy > 0.0);
  leaving.store(&exits.lightDirCrystal[0][exits.count], direction.x);
  leaving.store(&exits.lightDirCrystal[1][exits.count], direction.y);
  leaving.store(&exits.lightDirCrystal[2][exits.count], direction.z);
  leaving.store(&exits.energy[exits.count], energy);
  leaving.store(&exits.ray[exits.count], ray);
  leaving.store(&exits.order[exits.count], order);
  exits.count += leaving.count();
}

void enter(const FaceTable& faces, std::uint64_t seed, PathRule rule, int member, RayQueue& queue, ExitList& exits,
           EnergyUnits& energy) {
  UnitSum out;
  for (int i = 0; i < queue.count; i += kLanes) {
    const int ray = queue.ray(member, i);
    const Mask real = below(i, queue.count);
    const Triple<Real> light = loadTriple(queue.lightCrystal, i);
    const Real face = load<Real>(&queue.face[i]), weight = load<Real>(&queue.weight[i]);
    const Triple<Real> normal = normalOf(faces, face);
    const Real cosTheta_i = higher(-dot(normal, light), Real{});
    const RelativeIndexOf<Real> index(load<Real>(&queue.iceIndex[ray]));
    // The path's first number; the others are drawn from where it stays inside.
    const RandomWords words = randomWords(seed, RandomPurpose::path, 0, load<Words>(&queue.bundle[i]));
    PathRandom<Real> random{words.first, words.second};
    const BranchLanes b = branch(weight, weight * rule.splitShare, random.next(), cosTheta_i, index);

    store(&queue.energy[ray], b.transmitted);
    const Triple<Real> inside = renormalised(refract(light, normal, cosTheta_i, b.cosTheta_t, index));
    storeTriple(queue.inside, ray, inside);
    store(&queue.random0[i], random.state0);
    store(&queue.random1[i], random.state1);
    const Real reflected = select(real, b.reflected, Real{});
    out.add(reflected);
    leave(reflect(light, normal, cosTheta_i), reflected, counting() + static_cast<double>(ray), Real{}, exits);
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

/// One encounter of the rays from place i on; returns those whose path ends here.
PARHELION_INLINE Mask meetFace(const FaceTable& faces, int i, RayPool& pool, ExitList& exits, UnitSum& out) {
  const Triple<Real> light = loadTriple(pool.lightDir, i);
  const Real face = higher(load<Real>(&pool.nextFace[i]), Real{}), cosine = load<Real>(&pool.cosine[i]);
  const Real distance = load<Real>(&pool.distance[i]), energy = load<Real>(&pool.energy[i]);
  const Real order = load<Real>(&pool.order[i]) + 1.0;
  store(&pool.internalPath[i], load<Real>(&pool.internalPath[i]) + energy * distance);
  storeTriple(pool.point, i, loadTriple(pool.point, i) + distance * light);
  store(&pool.face[i], face);
  store(&pool.order[i], order);

  PathRandom<Real> random{load<Words>(&pool.random0[i]), load<Words>(&pool.random1[i])};
  const auto index = RelativeIndexOf<Real>::outOf(load<Real>(&pool.iceIndex[i]), load<Real>(&pool.perIceIndex[i]));
  const BranchLanes b = branch(energy, load<Real>(&pool.splitAbove[i]), random.next(), cosine, index);
  store(&pool.random0[i], random.state0);
  store(&pool.random1[i], random.state1);

  // The light comes from inside, where the normal does not point.
  const Triple<Real> outward = normalOf(faces, face), inward{-outward.x, -outward.y, -outward.z};
  out.add(b.transmitted);
  leave(refract(light, inward, cosine, b.cosTheta_t, index), b.transmitted, load<Real>(&pool.ray[i]), order, exits);
  storeTriple(pool.lightDir, i, renormalised(reflect(light, inward, cosine)));
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

void meetFaces(const FaceTable& faces, RayPool& pool, ExitList& exits, EnergyUnits& energy) {
  UnitSum out, lost;
  pool.endedCount = 0;
  for (int i = 0; i < pool.active; i += kLanes) {
    loseLight(i, pool, lost, energy);
    const Compress<Real> ended(meetFace(faces, i, pool, exits, out) & below(i, pool.active));
    ended.store(&pool.ended[pool.endedCount], counting() + static_cast<double>(i));
    pool.endedCount += ended.count();
  }
  energy.out += out.total();
  energy.lost += lost.total();
}

/// The numbers of three rows at the lanes' places.
PARHELION_INLINE Triple<Real> lookUpTriple(const RayQueue::Row* rows, const Real& place) {
  return {lookUp(rows[0].data(), place), lookUp(rows[1].data(), place), lookUp(rows[2].data(), place)};
}

void turnToWorld(const RayQueue& queue, ExitList& exits) {
  const Words placeBits = Words{} + static_cast<std::uint64_t>(queue.room - 1);
  for (int i = 0; i < exits.count; i += kLanes) {
    // The last digits of a ray's number are its place.
    const Words ray = bitsAs<Words>(load<Real>(&exits.ray[i]) + 0x1p52) & placeBits;
    const Real place = bitsAs<Real>(ray | bitsAs<Words>(Real{} + 0x1p52)) - 0x1p52;
    const Triple<Real> d = loadTriple(exits.lightDirCrystal, i);
    const Triple<Real> world =
        renormalised(d.x * lookUpTriple(queue.crystalX, place) + d.y * lookUpTriple(queue.crystalY, place) +
                     d.z * lookUpTriple(queue.crystalZ, place));
    const Triple<Real> change = world - lookUpTriple(queue.lightWorld, place);
    const Mask undeviated = dot(change, change) < kSameDirection * kSameDirection;
    storeTriple(exits.lightDirWorld, i, world);
    store(&exits.undeviated[i], select(undeviated, all<Real>(1.0), Real{}));
  }
}

void see(const Camera& camera, bool mirrored, const ExitList& exits, SeenLight& seen) {
  const Lens lens = camera.lens();
  const double side = mirrored ? 1.0 : -1.0;
  for (int i = 0; i < exits.count; i += kLanes) {
    const Triple<Real> light = loadTriple(exits.lightDirWorld, i);
    const auto place = lens.project<Real>({-light.x, side * light.y, -light.z});
    const Mask real = below(i, exits.count) & (load<Real>(&exits.undeviated[i]) == 0.0);
    const Compress<Real> inside(place.inside & real);
    inside.store(&seen.pixel[seen.count], wholePart(place.y) * lens.width + wholePart(place.x));
    inside.store(&seen.energy[seen.count], load<Real>(&exits.energy[i]));
    inside.store(&seen.ray[seen.count], load<Real>(&exits.ray[i]));
    seen.count += inside.count();
  }
}

}  // namespace

#define PARHELION_PASTE(a, b) a##b
#define PARHELION_KERNELS(lanes) PARHELION_PASTE(kernelsOf, lanes)

extern const Kernels PARHELION_KERNELS(PARHELION_LANES);
const Kernels PARHELION_KERNELS(PARHELION_LANES) = {kLanes,    draw,      propose,     enter,
                                                    findFaces, meetFaces, turnToWorld, see};

}  // namespace parhelion
