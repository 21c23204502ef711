// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "trace/light_path.h"

namespace parhelion {

/// Something that adds up light paths. Sums are exact integers, so the order of adding and merging leaves no trace.
class PathTally {
 public:
  virtual ~PathTally() = default;

  /// Adds the paths of one bundle: rays that differ in wavelength alone, and whose light is therefore correlated.
  virtual void add(std::span<const LightPath> bundle) = 0;

  /// An empty tally of the same kind for one thread, to be given to merge() in the end.
  virtual std::unique_ptr<PathTally> forThread() = 0;

  /// Takes over what a tally made by forThread() has added up, which is of no use afterwards.
  virtual void merge(PathTally& fromThread) = 0;
};

}  // namespace parhelion
