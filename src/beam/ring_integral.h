// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "beam/sky_integral.h"

namespace parhelion {

/// The light of rings of equal angle about a point of the sun, per surface of the crystals (their mean shadows).
struct RingIntegral {
  std::vector<Tristimulus> light;
  std::vector<double> error;  // of Y; those of neighbouring rings go together
  SheetTotals totals;
  long directions = 0;  // traced
  bool reached = false;
};

/// Light of rings, kept from one picture to the next: the sun's place does not matter to it.
class RingStore {
 public:
  /// All that decides what it is.
  struct Kind {
    std::vector<PrismShare> prisms;
    std::vector<double> indices;
    LightSegments lights;
    double error, cutShare;
    int rings;

    bool operator==(const Kind&) const = default;
  };

  /// Where they are looked for that are not here, and kept as well, so that they outlive the process.
  struct Elsewhere {
    std::function<std::optional<RingIntegral>(const Kind&)> find;
    std::function<void(const Kind&, const RingIntegral&)> keep;
  };

  RingStore() = default;
  explicit RingStore(Elsewhere elsewhere) : elsewhere_(std::move(elsewhere)) {}

  /// Null if it is not kept.
  const RingIntegral* find(const Kind& kind);

  /// Keeps it, if not many are kept already.
  void add(const Kind& kind, const RingIntegral& rings);

 private:
  void addHere(const Kind& kind, const RingIntegral& rings);

  Elsewhere elsewhere_;
  std::optional<RingIntegral> found_;  // elsewhere
  std::vector<std::pair<Kind, RingIntegral>> kept_;
};

/// Integrates the light of randomly oriented crystals: of a scene its prisms and its light count. The same bits for any
/// number of threads, and whatever the store has.
RingIntegral integrateRings(const AxisScene& scene, const SkyAccuracy& accuracy, int rings, RingStore& store);

}  // namespace parhelion
