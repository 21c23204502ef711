// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crystal/crystal_mesh.h"

namespace parhelion {

/// The largest distance between two corners of a crystal, at any stretch along c that its mesh may have.
struct CrystalSpan {
  explicit CrystalSpan(const CrystalMesh& mesh);

  double at(double stretch) const;

 private:
  // Of prismatic meshes, whose two ends are alike, across c and along it; of others all of it is across.
  double across_ = 0.0, along_ = 0.0;
};

/// Two sides of the rectangle that stands for a face: it has the face's second moments. That of a rectangular face is
/// the face itself.
struct FaceRectangle {
  Vec3 one, other;  // in the face's plane, crystal units
};
FaceRectangle rectangleOf(const CrystalMesh& mesh, int face);

}  // namespace parhelion
