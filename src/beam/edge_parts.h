// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace parhelion {

/// Parts a triangle of orientations into four, and these again, up to `depth` times, where light of its class leaves at
/// some of its corners only: corners have `excess`, which is not above 0 under total reflection. between(a, b) is a
/// corner half-way, add(a, b, c, share) gets those parts at which light leaves, with their share of the triangle. What
/// isSmall(a, b, c) is not parted any more.
template <class Corner, class Between, class Add, class IsSmall>
void addParts(const Corner& a, const Corner& b, const Corner& c, double share, int depth, const Between& between,
              const Add& add, const IsSmall& isSmall) {
  if (std::max({a.excess, b.excess, c.excess}) <= 0.0) return;
  if (std::min({a.excess, b.excess, c.excess}) > 0.0 || depth == 0 || isSmall(a, b, c)) return add(a, b, c, share);
  const Corner ab = between(a, b), bc = between(b, c), ca = between(c, a);
  addParts(a, ab, ca, 0.25 * share, depth - 1, between, add, isSmall);
  addParts(ab, b, bc, 0.25 * share, depth - 1, between, add, isSmall);
  addParts(ca, bc, c, 0.25 * share, depth - 1, between, add, isSmall);
  addParts(ab, bc, ca, 0.25 * share, depth - 1, between, add, isSmall);
}

}  // namespace parhelion
