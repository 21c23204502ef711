// SPDX-License-Identifier: Apache-2.0
#include "trace/concave_entry.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "math/random.h"

namespace parhelion {

namespace {

/// What of a crystal looks toward the light.
struct LitFaces {
  LitFaces(const ConcaveCrystal& crystal, const Vec3& lightDir) {
    for (const Face& face : crystal.mesh().faces()) {
      const double cosine = -glm::dot(face.normal, lightDir);
      total += cosine > 0.0 ? cosine * face.area : 0.0;
      upTo.push_back(total);
    }
  }

  std::vector<double> upTo;  // shadows of the faces up to each
  double total = 0.0;        // of all, each by itself
};

/// The point that three numbers in (0, 1) choose, uniform over the shadows of all lit faces.
EntryPoint pointOf(const ConcaveCrystal& crystal, const LitFaces& lit, double u, double u1, double u2) {
  const auto found = std::ranges::lower_bound(lit.upTo, u * lit.total);
  const int face = static_cast<int>(
      std::min<std::ptrdiff_t>(found - lit.upTo.begin(), static_cast<std::ptrdiff_t>(lit.upTo.size()) - 1));
  double left = u1 * crystal.mesh().faces()[face].area;
  int at = crystal.firstTriangle(face);
  const auto& triangles = crystal.triangles();
  while (at + 1 < crystal.firstTriangle(face + 1) && left > triangles[at].area) left -= triangles[at++].area;
  const ConcaveCrystal::Triangle& triangle = triangles[at];
  // What is left of u1 is uniform again; the square root makes the triangle uniform.
  const double s = std::sqrt(std::min(1.0, left / triangle.area));
  return {face, triangle.corner + s * (1.0 - u2) * triangle.ab + s * u2 * triangle.ac};
}

/// Whether light comes to a point of a lit face without meeting the crystal before.
bool isFirst(const ConcaveCrystal& crystal, const EntryPoint& entry, const Vec3& lightDir) {
  return crystal.isOnHull(entry.face) || !crystal.nextFace(entry.point, -lightDir, entry.face, Side::outside);
}

/// The shadows of all lit faces over the number of points that it takes to find one that light meets first: the mean of
/// the inverse is that of the silhouette's. `u` starts a sequence of numbers.
double silhouette(const ConcaveCrystal& crystal, const LitFaces& lit, const Vec3& lightDir, double u1, double u2) {
  auto random = pathRandom<double>(std::bit_cast<std::uint64_t>(u1), std::bit_cast<std::uint64_t>(u2));
  for (int tries = 1;; ++tries) {
    const double a = random.next(), b = random.next(), c = random.next();
    if (isFirst(crystal, pointOf(crystal, lit, a, b, c), lightDir)) return lit.total / tries;
  }
}

void put(RayQueue::Row* rows, int place, const Triple<double>& v) {
  rows[0][place] = v.x;
  rows[1][place] = v.y;
  rows[2][place] = v.z;
}

}  // namespace

void proposeConcave(const ConcaveCrystal& crystal, const IncidenceTable& table, const IncidenceNumbers& numbers,
                    Proposals& proposals, RayQueue& queue) {
  const CrystalMesh& mesh = crystal.mesh();
  const double surface = mesh.surfaceAcrossC() + mesh.surfaceAlongC();
  for (int i = 0; i < proposals.count; ++i) {
    const auto u = [&](IncidenceNumber what) { return numbers.row[what][i]; };
    const auto axes = table.orientation.at(u(kZenith), u(kAzimuth), u(kRoll));
    Triple<double> toSun = table.toSun;
    if (table.sunDisc) toSun = table.sunDisc->toPoint(u(kSunRadius), u(kSunAngle));
    const Triple<double> world = -toSun;
    const Vec3 light(dot(axes.x, world), dot(axes.y, world), dot(axes.z, world));

    const LitFaces lit(crystal, light);
    const double ratio = lit.total / surface / table.bound;
    const EntryPoint entry = pointOf(crystal, lit, u(kEntryFace), u(kEntryS), u(kEntryT));
    if ((table.rejects && !(u(kAcceptance) < ratio)) || !isFirst(crystal, entry, light)) {
      proposals.rejected[proposals.rejectedCount++] = proposals.bundle[i];
      continue;
    }
    const int place = queue.count++;
    queue.bundle[place] = proposals.bundle[i];
    put(queue.crystalX, place, axes.x);
    put(queue.crystalY, place, axes.y);
    put(queue.crystalZ, place, axes.z);
    put(queue.lightWorld, place, world);
    put(queue.lightCrystal, place, {light.x, light.y, light.z});
    put(queue.point, place, {entry.point.x, entry.point.y, entry.point.z});
    queue.face[place] = entry.face;
    queue.stretch[place] = 1.0;
    queue.shadow[place] = silhouette(crystal, lit, light, u(kEntryS), u(kEntryT));
    queue.weight[place] = table.lightPerRay * (table.rejects ? std::max(1.0, ratio) : ratio);
  }
}

}  // namespace parhelion
