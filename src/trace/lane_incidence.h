// SPDX-License-Identifier: Apache-2.0
#pragma once

// Part of lane_code.cpp, and of nothing else.

#include "trace/lane_types.h"

namespace parhelion {
namespace {

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

}  // namespace
}  // namespace parhelion
