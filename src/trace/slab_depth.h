// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "trace/extinction.h"

namespace parhelion {

/// What a slab of crystals takes out of light by the direction it goes in: Extinction made ready to be asked often.
class SlabDepth {
 public:
  /// `extinction` must outlive it.
  SlabDepth(const Extinction& extinction, double opticalDepth);

  /// From the top to the bottom along a unit vector, of light that is scattered and does not pass undeviated. A way
  /// along the horizon is very long, and not without an end.
  double along(const Vec3& direction) const;

 private:
  double vertical(const Vec3& direction) const;

  const Extinction& extinction_;
  double opticalDepth_;
  std::vector<double> byRise_;  // by the root of the elevation's sine; none where azimuths matter
};

}  // namespace parhelion
