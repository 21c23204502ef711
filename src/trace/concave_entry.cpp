// SPDX-License-Identifier: Apache-2.0
#include "trace/concave_entry.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/geometric.hpp>

#include "math/random.h"

namespace parhelion {

LitSide::LitSide(const ConcaveCrystal& crystal, const Vec3& lightDir) : crystal_(crystal), lightDir_(lightDir) {
  for (const Face& face : crystal.mesh().faces()) {
    const double cosine = -glm::dot(face.normal, lightDir);
    total_ += cosine > 0.0 ? cosine * face.area : 0.0;
    upTo_.push_back(total_);
  }
}

/// The point that three numbers in (0, 1) choose, uniform over the shadows of all lit faces.
EntryPoint LitSide::pointAt(double u, double u1, double u2) const {
  const auto found = std::ranges::lower_bound(upTo_, u * total_);
  const int face =
      static_cast<int>(std::min<std::ptrdiff_t>(found - upTo_.begin(), static_cast<std::ptrdiff_t>(upTo_.size()) - 1));
  double left = u1 * crystal_.mesh().faces()[face].area;
  int at = crystal_.firstTriangle(face);
  const auto& triangles = crystal_.triangles();
  while (at + 1 < crystal_.firstTriangle(face + 1) && left > triangles[at].area) left -= triangles[at++].area;
  const ConcaveCrystal::Triangle& triangle = triangles[at];
  // What is left of u1 is uniform again; the square root makes the triangle uniform.
  const double s = std::sqrt(std::min(1.0, left / triangle.area));
  return {face, triangle.corner + s * (1.0 - u2) * triangle.ab + s * u2 * triangle.ac};
}

/// Whether light comes to a point of a lit face without meeting the crystal before.
bool LitSide::isFirst(const EntryPoint& point) const {
  return crystal_.isOnHull(point.face) || !crystal_.nextFace(point.point, -lightDir_, point.face, Side::outside);
}

std::optional<EntryPoint> LitSide::entry(double u, double u1, double u2) const {
  const EntryPoint point = pointAt(u, u1, u2);
  return isFirst(point) ? std::optional(point) : std::nullopt;
}

/// All lit faces over the number of points that it takes to find one that light meets first.
double LitSide::silhouette(double u1, double u2) const {
  auto random = pathRandom<double>(std::bit_cast<std::uint64_t>(u1), std::bit_cast<std::uint64_t>(u2));
  for (int tries = 1;; ++tries) {
    const double a = random.next(), b = random.next(), c = random.next();
    if (entry(a, b, c)) return total_ / tries;
  }
}

namespace {

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

    const LitSide lit(crystal, light);
    const double ratio = lit.total() / surface / table.bound;
    const bool isRejected = table.rejects && !(u(kAcceptance) < ratio);
    const auto entry = isRejected ? std::nullopt : lit.entry(u(kEntryFace), u(kEntryS), u(kEntryT));
    if (!entry) {
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
    put(queue.point, place, {entry->point.x, entry->point.y, entry->point.z});
    queue.face[place] = entry->face;
    queue.stretch[place] = 1.0;
    queue.shadow[place] = lit.silhouette(u(kEntryS), u(kEntryT));
    queue.weight[place] = table.lightPerRay * (table.rejects ? std::max(1.0, ratio) : ratio);
  }
}

}  // namespace parhelion
