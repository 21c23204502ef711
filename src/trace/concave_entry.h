// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "crystal/crystal.h"
#include "trace/concave_crystal.h"
#include "trace/lane_steps.h"

namespace parhelion {

/// What of a crystal of any form looks toward light of a direction (unit, crystal frame). Both must outlive it.
class LitSide {
 public:
  LitSide(const ConcaveCrystal& crystal, const Vec3& lightDir);

  /// The shadows of all lit faces, each by itself, crystal units squared: no less than the silhouette.
  double total() const { return total_; }

  /// Where light meets the crystal first, for three numbers in (0, 1): uniform over the silhouette. A point of all lit
  /// faces is drawn, and none is returned where another part of the crystal lies before it.
  std::optional<EntryPoint> entry(double u, double u1, double u2) const;

  /// An estimate of the silhouette, whose inverse has the right mean. Two numbers in (0, 1) start what it draws.
  double silhouette(double u1, double u2) const;

 private:
  EntryPoint pointAt(double u, double u1, double u2) const;
  bool isFirst(const EntryPoint& point) const;

  const ConcaveCrystal& crystal_;
  const Vec3& lightDir_;
  std::vector<double> upTo_;  // shadows of the faces up to each
  double total_ = 0.0;
};

/// LaneSteps::propose for crystals of any form, which are rejected where their LitSide has no entry, too. So they are
/// taken in proportion to their silhouettes. The queue's shadow is LitSide::silhouette().
void proposeConcave(const ConcaveCrystal& crystal, const IncidenceTable& table, const IncidenceNumbers& numbers,
                    Proposals& proposals, RayQueue& queue);

}  // namespace parhelion
