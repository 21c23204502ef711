// SPDX-License-Identifier: Apache-2.0
#pragma once

// Part of lane_code.cpp, and of nothing else.

#include "crystal/entry.h"
#include "trace/lane_types.h"

namespace parhelion {
namespace {

void draw(std::uint64_t seed, RandomPurpose purpose, const std::uint64_t* bundle, int count, std::uint32_t firstBlock,
          int blocks, IncidenceNumbers& numbers) {
  for (int b = 0; b < blocks; ++b) {
    double* first = numbers.row[2 * b].data();
    double* second = numbers.row[2 * b + 1].data();
    for (int i = 0; i < count; i += kLanes) {
      const RandomWords<Words> words = randomWords(seed, purpose, firstBlock + b, load<Words>(bundle + i));
      store(first + i, toUnitInterval<Real>(words.first));
      store(second + i, toUnitInterval<Real>(words.second));
    }
  }
}

void propose(const IncidenceTable& table, const IncidenceNumbers& numbers, Proposals& proposals, RayQueue& queue) {
  const FaceTable& faces = *table.faces;
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
    const Triple<Real> world = -toSun;
    const Triple<Real> light{dot(axes.x, world), dot(axes.y, world), dot(axes.z, world)};

    const Shadows<Real> shadows = castShadows(faces, stretch, light);
    const Real ratio = shadows.total / (faces.surfaceAcrossC + faces.surfaceAlongC * stretch) / table.bound;
    const Mask real = below(i, proposals.count);
    const Mask take = table.rejects ? real & (u(kAcceptance, i) < ratio) : real;
    const Real weight = table.lightPerRay * (table.rejects ? higher(ratio, all<Real>(1.0)) : ratio);
    const Real face = litFace(faces, shadows, u(kEntryFace, i));
    const Triple<Real> point = pointOnFace(faces, stretch, face, u(kEntryS, i), u(kEntryT, i));

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
