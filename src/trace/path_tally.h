// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "trace/traced_rays.h"

namespace parhelion {

/// Something that adds up the light of traced rays. Sums are exact integers, so the order of adding and merging leaves
/// no trace.
class PathTally {
 public:
  virtual ~PathTally() = default;

  /// Adds what left the crystals of some bundles. The rays of a bundle differ in wavelength alone; their light is
  /// correlated. Returns how many times light has found a place here: exits out of view have none, mirrored ones two.
  virtual int add(const TracedRays& traced) = 0;

  /// An empty tally of the same kind for one thread, to be given to merge() in the end.
  virtual std::unique_ptr<PathTally> forThread() = 0;

  /// Takes over what a tally made by forThread() has added up, which is of no use afterwards.
  virtual void merge(PathTally& fromThread) = 0;

  /// Called once, after the last merge.
  virtual void finish() {}
};

}  // namespace parhelion
