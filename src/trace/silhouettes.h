// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "crystal/crystal_mesh.h"

namespace parhelion {

/// The silhouettes of a crystal of any form by the light's direction: tabulated every 2 degrees, and linear between.
/// Right to 1e-3.
class Silhouettes {
 public:
  /// In parallel; the same bits for any number of threads.
  explicit Silhouettes(const CrystalMesh& mesh);

  /// Toward light of a direction (unit, crystal frame), over the crystal's surface.
  double at(const Vec3& lightDir) const;

  /// Its mean over all directions.
  double mean() const;

 private:
  double node(int row, int column) const;

  std::vector<double> silhouettes_;  // rows of angles from the plane across c, from 0 to the pole; columns of azimuths
};

}  // namespace parhelion
