// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "beam/piece_tracer.h"
#include "beam/prism_tracer.h"

namespace parhelion {

/// A PrismTracer of the light alone whose path is wanted. Shadows are those of all light.
class WantedTracer {
 public:
  /// Without `wanted`, which must outlive this, all light is. `detailed`: as PrismTracer; the way inside is that of all
  /// light.
  WantedTracer(const PrismSection& section, double length, double index, double cutShare, bool detailed,
               const WantedPaths* wanted);

  void trace(const Vec3& lightDir, PrismLight& light);
  void meetOutside(const Vec3& lightDir, PrismLight& light) const;

 private:
  PrismTracer all_;
  bool detailed_;
  const WantedPaths* wanted_;
  const WantedPaths* others_ = nullptr;  // where these are followed, and taken away from all
  std::optional<PieceTracer> pieces_;
  PrismLight rest_;
};

}  // namespace parhelion
