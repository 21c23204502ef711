// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "beam/light_class.h"
#include "beam/scatter_scene.h"
#include "beam/wanted_paths.h"
#include "math/inline.h"

namespace parhelion {

/// What stands in the light: prisms of one cross-section, shares of one surface.
struct TracedPrisms {
  PrismSection section;
  std::vector<PrismShare> prisms;
  std::vector<double> indices;  // at which light is traced; all others lie between them
  double cutShare = 1e-5;       // PrismTracer
  const WantedPaths* wanted = nullptr;
};

/// A direction of light in the crystal's frame by its azimuth and its angle from -c, on which side of a plane of
/// symmetry it is traced (TracedDirection), and how much of a row's mean it is.
struct RowDirection {
  double phi, zeta, towards, weight;
};

/// What becomes of light of a few directions: that of each class, at each index.
class LightRow {
 public:
  /// What crystals intercept and what was cut off: means over the row.
  struct Totals {
    double intercepted = 0.0, cutOff = 0.0;
  };

  /// A row that is not traced.
  LightRow() = default;
  /// `room`: numbers kept for each class and index, some of them behind the last direction.
  LightRow(const TracedPrisms& prisms, std::span<const RowDirection> directions, std::size_t room);

  bool isTraced() const { return !totals_.empty(); }

  /// Numbers of the classes (LightClass) that have light.
  const std::vector<int>& classes() const { return classes_; }

  /// Whether a class has any.
  bool has(int number) const { return slot_[static_cast<std::size_t>(number)] >= 0; }

  /// Adds the light that meets the exit of a class that has any, per surface, in units of mean shadows, times `weight`.
  /// `parts`: how much of each index's light makes it.
  PARHELION_INLINE void addTo(int number, const std::vector<double>& parts, double weight, double* light) const {
    const auto slot = static_cast<std::size_t>(slot_[static_cast<std::size_t>(number)]);
    for (std::size_t n = 0; n < parts.size(); ++n) {
      const double part = weight * parts[n];
      if (part == 0.0) continue;
      const float* met = light_.data() + (slot * parts.size() + n) * room_;
      for (std::size_t k = 0; k < room_; ++k) light[k] += part * static_cast<double>(met[k]);
    }
  }

  /// All light that is wanted, and that is intercepted, of all directions and indices alike.
  double met() const { return met_; }
  double intercepted() const;

  Totals totals(const std::vector<double>& parts) const;

 private:
  void findClasses();

  std::size_t room_ = 0;
  double met_ = 0.0;
  std::vector<int> classes_;
  std::vector<short> slot_;     // of each class; negative without light
  std::vector<float> light_;    // by slot, index and direction
  std::vector<Totals> totals_;  // by index
};

/// Numbers of all classes that have light in any of some rows, rising.
std::vector<int> classesOf(std::span<const LightRow> rows);

}  // namespace parhelion
