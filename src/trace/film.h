// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "trace/traced_rays.h"

namespace parhelion {

/// Something that adds up the light of traced rays: a picture, a map or a profile. Sums are exact integers, so the
/// result does not depend on the order of adding and merging.
class Film {
 public:
  virtual ~Film() = default;

  /// Adds what left the crystals of some bundles. The rays of a bundle differ only in wavelength, so their light is
  /// correlated. Returns how many times light found a place here. An exit that is out of view finds none, and one that
  /// also counts as its mirror image may find two.
  virtual int add(const TracedRays& traced) = 0;

  /// Makes an empty tally of the same kind for one thread. It is given to merge() at the end.
  virtual std::unique_ptr<Film> forThread() = 0;

  /// Takes over what a tally made by forThread() has added up. That tally must not be used afterwards.
  virtual void merge(Film& fromThread) = 0;

  /// Called once, after the last merge.
  virtual void finish() {}
};

}  // namespace parhelion
