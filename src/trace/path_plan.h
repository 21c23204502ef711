// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "crystal/raypath/path_automaton.h"
#include "crystal/raypath/path_code.h"
#include "trace/cloud.h"
#include "trace/path_record.h"
#include "trace/path_settings.h"

namespace parhelion {

/// How a run keeps and sorts raypaths: PathSettings made ready for the populations of a cloud. Immutable; safe to use
/// from many threads.
class PathPlan {
 public:
  /// `sequences`: whether the faces themselves are wanted, besides what the settings need. Throws std::invalid_argument
  /// for more than kMostLayers layers, and for patterns that are too intricate together.
  PathPlan(const Cloud& cloud, const PathSettings& settings, bool sequences = false);

  PathRecord record() const { return record_; }

  /// What is kept of the paths of a population; the others are for records that keep something.
  PathTable table(int population) const {
    return record_ == PathRecord::nothing ? PathTable{} : populations_[population].table;
  }
  const PathAutomaton& automaton(int population) const { return populations_[population].automaton; }
  const PathCode& code(int population) const { return populations_[population].code; }

  bool hasFilter() const { return hasFilter_; }

  /// Whether the tilt of a population's crystals decides on the layer of their light.
  bool hasTilts(int population) const { return !populations_[population].tilted.empty(); }

  /// Layers that have a name. The rest is one more, after them.
  int layers() const { return layers_; }

  /// The layers that may take light of a crystal whose rotation has these columns: by its tilt, a bit each.
  std::uint64_t layersFor(int population, const Vec3& crystalY, const Vec3& crystalZ) const {
    const OfPopulation& plan = populations_[population];
    const Vec3& axis = plan.tiltsCrystalY ? crystalY : crystalZ;
    const double horizontal = std::sqrt(axis.x * axis.x + axis.y * axis.y);
    std::uint64_t allowed = ~std::uint64_t{0};
    for (const TiltedLayer& layer : plan.tilted)
      if (!layer.from.isOutside(horizontal, axis.z) || !layer.to.isWithin(horizontal, axis.z)) allowed &= ~layer.bit;
    return allowed;
  }

  /// Whether the filter keeps light in this state of the population's automaton.
  bool keeps(int population, double state) const { return populations_[population].kept[static_cast<int>(state)]; }

  /// By state of the population's automaton: the layer of light, if tilts do not matter.
  const std::vector<int>& layersOf(int population) const { return populations_[population].layers; }

  /// The layer of light in this state, of those that layersFor() allows.
  int layerOf(int population, double state, std::uint64_t allowed) const {
    const std::uint64_t taken = populations_[population].takenBy[static_cast<int>(state)] & allowed;
    return layerIn(taken);
  }

 private:
  int layerIn(std::uint64_t taken) const { return taken != 0 ? std::countr_zero(taken) : layers_; }

  /// An open range of zenith angles, and how to tell whether an axis points into it without finding its angle.
  class ZenithRange {
   public:
    ZenithRange(double from, double to);
    bool isWithin(double horizontal, double z) const { return isAbove(horizontal, z) && isBelow(horizontal, z); }
    bool isOutside(double horizontal, double z) const { return !isWithin(horizontal, z); }

   private:
    /// By the sine of the difference of two angles.
    bool isAbove(double horizontal, double z) const {
      return fromNowhere_ || horizontal * cosFrom_ - z * sinFrom_ > 0.0;
    }
    bool isBelow(double horizontal, double z) const { return toNowhere_ || z * sinTo_ - horizontal * cosTo_ > 0.0; }

    bool fromNowhere_, toNowhere_;  // a bound is beyond the zenith or the nadir
    double sinFrom_, cosFrom_, sinTo_, cosTo_;
  };

  struct TiltedLayer {
    std::uint64_t bit;
    ZenithRange from, to;  // zenith angles of tilts below each bound
  };

  struct OfPopulation {
    PathAutomaton automaton;
    PathCode code;
    PathTable table;
    std::vector<std::uint64_t> takenBy;  // by state: layers whose pattern takes it
    std::vector<int> layers;             // by state: the first of them
    std::vector<char> kept;              // by state: whether the filter does
    bool tiltsCrystalY = false;          // their tilt is that of crystal +y, else of the c axis
    std::vector<TiltedLayer> tilted;
  };
  OfPopulation planFor(const Population& population, const PathSettings& settings) const;

  std::vector<OfPopulation> populations_;
  bool hasFilter_;
  int layers_;
  PathRecord record_;
};

}  // namespace parhelion
