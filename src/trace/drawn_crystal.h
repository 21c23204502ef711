// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "crystal/face_table.h"
#include "crystal/population.h"
#include "crystal/span.h"

namespace parhelion {

/// The crystal that a block of bundles meets in a population whose shapes are spread. Blocks take their shapes from a
/// sequence that fills the distributions evenly, so that few of them already stand for all.
struct DrawnCrystal {
  DrawnCrystal(const Population& population, std::uint64_t seed, std::uint64_t number)
      : block(number), mesh(population.crystalOfBlock(seed, number).second), faces(mesh), span(mesh) {}

  std::uint64_t block;
  CrystalMesh mesh;
  FaceTable faces;
  CrystalSpan span;
};

}  // namespace parhelion
