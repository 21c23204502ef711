// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "crystal/crystal.h"
#include "crystal/orientation.h"

namespace parhelion {

/// Crystals of one kind, ready to be drawn from.
class Population {
 public:
  /// Throws std::invalid_argument when the settings describe no crystal.
  explicit Population(const PopulationSettings& settings);

  const std::string& name() const { return name_; }
  double weight() const { return weight_; }
  bool isMirrorSymmetric() const { return mirrorSymmetric_; }
  bool isFullyRandom() const { return fullyRandom_; }
  const CrystalMesh& mesh() const { return *mesh_; }

  /// What the mesh is stretched by along c, spread over shares of surface; none when all crystals are alike.
  const AngleQuantile* stretch() const { return aspect_ ? &aspect_->quantile() : nullptr; }

  /// How the crystals stand, and the same for lanes.
  const OrientationSettings& orientation() const { return orientationSettings_; }
  const OrientationQuantile& orientationQuantile() const { return orientation_.quantile(); }

 private:
  std::string name_;
  double weight_;
  bool mirrorSymmetric_, fullyRandom_;       // crystal/symmetry.h
  std::shared_ptr<const CrystalMesh> mesh_;  // at its only aspect ratio, or at aspect 1 to be stretched
  std::optional<ValueSampler> aspect_;       // when it is spread
  OrientationSettings orientationSettings_;
  OrientationSampler orientation_;
};

}  // namespace parhelion
