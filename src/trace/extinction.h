// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "crystal/population_settings.h"
#include "math/conventions.h"
#include "optics/light_settings.h"
#include "trace/haze_settings.h"

namespace parhelion {

/// The mean shadow of a convex body in any orientation, in units of its surface (Cauchy).
inline constexpr double kRandomShadow = 0.25;

/// What crystals take from light by the direction it comes from: oriented crystals stand in the way of light from some
/// directions more than of light from others.
///
/// Tabulated over half the sky, and linear between; the same for opposite directions. Shadows are right to a
/// thousandth; those of crystals that are not convex are their silhouettes. What passes undeviated is found by some ten
/// thousand rays for each direction: right to half a hundredth of all light.
class Extinction {
 public:
  /// Of crystals as light of that sun's spectrum meets them. In parallel; the same bits for any number of threads.
  /// Throws std::invalid_argument when no population has any weight.
  Extinction(const SunSettings& sun, const IceSettings& ice, std::span<const PopulationSettings> populations,
             std::span<const HazeSettings> hazes = {});

  /// Of some of the populations and hazes alone, by their indices. Throws std::invalid_argument when none of them has
  /// any weight.
  Extinction part(std::span<const std::size_t> populations, std::span<const std::size_t> hazes) const;

  struct Crystals {
    double shadow;        // their mean, in units of that of light from the zenith
    double undeviated;    // how much of what meets them goes on as if they were not there, through parallel faces
    double ofHaze = 0.0;  // how much of the shadow is that of haze

    /// What a cloud of that vertical optical depth scatters of light from this direction, as a depth over the sine of
    /// its elevation: light that passes undeviated goes on.
    double depth(double opticalDepth) const { return opticalDepth * (1.0 - undeviated) * shadow; }
  };

  /// Whether azimuths make no difference.
  bool isSameAllAround() const;

  /// What light from a direction meets.
  Crystals at(const Vec3& toLight) const;

  /// What is 1 for at(): the mean shadow on light from the zenith, in units of the surface that a weight of 1 stands
  /// for.
  double zenithShadow() const { return zenith_; }

  /// The shadow of haze in the same units, from all sides.
  double hazeShadow(std::size_t haze) const { return hazes_[haze]; }

 private:
  /// A direction of the upper half of the sky: the root of its elevation over a right angle, and its azimuth in turns.
  struct Place {
    double root, turns;
  };

  /// Numbers by direction: rows of elevations, from the horizon to the zenith, and columns of azimuths.
  class Table {
   public:
    Table(int rows, int columns) : rows_(rows), columns_(columns), numbers_(static_cast<std::size_t>(rows * columns)) {}
    std::size_t size() const { return numbers_.size(); }
    bool isSameAllAround() const { return columns_ == 1; }
    Vec3 directionOf(std::size_t k) const;  // azimuth 0 but for columns
    double& operator[](std::size_t k) { return numbers_[k]; }
    double at(const Place& place) const;

   private:
    double node(int row, int column) const {
      return numbers_[static_cast<std::size_t>(row * columns_ + column % columns_)];
    }
    int rows_, columns_;
    std::vector<double> numbers_;
  };

  struct Kind {
    std::size_t population;
    double weight;
    Table shadow, undeviated;
  };
  static Kind kindOf(const SunSettings& sun, const IceSettings& ice, std::span<const PopulationSettings> populations,
                     std::size_t population);
  void sumUp();

  std::vector<Kind> kinds_;
  std::vector<double> hazes_;  // their shadows, from all sides
  double haze_ = 0.0;          // all of them
  double zenith_ = 1.0;
};

}  // namespace parhelion
