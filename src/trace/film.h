// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <stdexcept>

#include "math/sum_visitor.h"
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

  /// Whether it reads the faces that light has met (ExitList::pathFirst and pathLast).
  virtual bool wantsSequences() const { return false; }

  /// Makes an empty film of the same kind for one thread. It is given to merge() in the end, and at any time before.
  virtual std::unique_ptr<Film> forThread() = 0;

  /// Takes over what a film made by forThread() has added up. That one is empty afterwards and may go on.
  virtual void merge(Film& fromThread) = 0;

  /// Makes the result of all that was merged: it can be read until the next reopen().
  virtual void finish() {}

  /// After finish(): more rays may be added.
  virtual void reopen() {}

  /// How full the fullest of all sums is, as they are after finish(), from 0 to 1. At 1 nothing more fits into it.
  virtual double fullness() const { return 0.0; }

  /// At most how full they would be, of what was merged so far: known without finish(), which takes longer.
  virtual double fullnessAtMost() const { return fullness(); }

  /// Shows all that was merged, as it is before finish(). Throws std::logic_error for films that are traced by one
  /// process only.
  virtual void visitSums(SumVisitor&) { throw std::logic_error("this film is for one process"); }
};

}  // namespace parhelion
