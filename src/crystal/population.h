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

  /// A crystal for one number in (0, 1); not used when all are alike. Aspect ratios are spread over shares of surface.
  Crystal crystal(double u) const;

  /// What crystal(u) is stretched by; none when all are alike.
  const AngleQuantile* stretch() const { return aspect_ ? &aspect_->quantile() : nullptr; }

  /// Crystal-to-world rotation for three numbers in (0, 1).
  Mat3 orientation(double u1, double u2, double u3) const { return orientation_.sample(u1, u2, u3); }
  const OrientationQuantile& orientation() const { return orientation_.quantile(); }

 private:
  std::string name_;
  double weight_;
  bool mirrorSymmetric_, fullyRandom_;  // crystal/symmetry.h
  std::shared_ptr<const CrystalMesh> mesh_;  // at its only aspect ratio, or at aspect 1 to be stretched
  std::optional<ValueSampler> aspect_;       // when it is spread
  OrientationSampler orientation_;
};

}  // namespace parhelion
