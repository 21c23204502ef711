// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "trace/extinction.h"
#include "trace/slab_settings.h"

namespace parhelion {

/// The layers of a cloud, from top to bottom, and what each of them takes from light.
class SlabStack {
 public:
  struct Layer {
    std::vector<std::size_t> populations, hazes;  // indices
    double opticalDepth;
    Extinction extinction;
  };

  /// `all` is the extinction of these populations and hazes. Throws std::invalid_argument for a layer of which nothing
  /// has any weight.
  SlabStack(const Extinction& all, std::span<const PopulationSettings> populations, std::span<const HazeSettings> hazes,
            const SlabSettings& settings);

  const std::vector<Layer>& layers() const { return layers_; }

  /// Depth of all layers along a unit vector, of light that is scattered and does not pass undeviated; for a rise of
  /// no less than `leastRise`.
  double depthAlong(const Vec3& direction, double leastRise) const;

 private:
  std::vector<Layer> layers_;
};

}  // namespace parhelion
