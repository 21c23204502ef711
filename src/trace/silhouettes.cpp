// SPDX-License-Identifier: Apache-2.0
#include "trace/silhouettes.h"

#include <algorithm>
#include <cmath>

#include "crystal/silhouette.h"
#include "math/arctangent.h"
#include "math/portable.h"
#include "parallel/loops.h"

namespace parhelion {

namespace {

// Nodes lie where prism faces and the faces across c are edge-on, and silhouettes have kinks.
constexpr int kRows = 46, kColumns = 180;
constexpr double kStep = 0.5 * kPi / (kRows - 1);

}  // namespace

Silhouettes::Silhouettes(const CrystalMesh& mesh) : silhouettes_(kRows * kColumns) {
  const double surface = mesh.surfaceAcrossC() + mesh.surfaceAlongC();
  forEach(silhouettes_.size(), [&](std::size_t k) {
    const portable::SinCos up = portable::sincos(kStep * static_cast<double>(k / kColumns)),
                           turn = portable::sincos(kStep * static_cast<double>(k % kColumns));
    const Vec3 direction(up.cos * turn.cos, up.cos * turn.sin, up.sin);
    silhouettes_[k] = silhouetteOf(mesh, direction) / surface;
  });
}

double Silhouettes::node(int row, int column) const {
  return silhouettes_[static_cast<std::size_t>(row * kColumns + column % kColumns)];
}

double Silhouettes::at(const Vec3& lightDir) const {
  const Vec3 up = lightDir.z < 0.0 ? -lightDir : lightDir;  // the same from opposite sides
  const double y = arctangent(up.z, std::sqrt(up.x * up.x + up.y * up.y)) / kStep,
               turn = arctangent(up.y, up.x) / kStep, x = turn < 0.0 ? turn + kColumns : turn;
  const int row = std::min(static_cast<int>(y), kRows - 2), column = std::min(static_cast<int>(x), kColumns - 1);
  const auto between = [](double a, double b, double t) { return a + t * (b - a); };
  return between(between(node(row, column), node(row, column + 1), x - column),
                 between(node(row + 1, column), node(row + 1, column + 1), x - column), y - row);
}

double Silhouettes::mean() const {
  double sum = 0.0, weights = 0.0;
  for (int row = 0; row < kRows; ++row) {
    // The share of the sphere that is nearer to this row than to others.
    const double weight =
        portable::sin(std::min(0.5 * kPi, (row + 0.5) * kStep)) - portable::sin(std::max(0.0, (row - 0.5) * kStep));
    for (int column = 0; column < kColumns; ++column) sum += weight * node(row, column);
    weights += weight * kColumns;
  }
  return sum / weights;
}

}  // namespace parhelion
