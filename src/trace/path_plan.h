// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
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
  bool hasTilts(int population) const { return populations_[population].hasTilts; }

  /// Layers that have a name. The rest is one more, after them.
  int layers() const { return layers_; }

  /// The layers that may take light of a crystal whose rotation has these columns: by its tilt, a bit each.
  std::uint64_t layersFor(const Population& population, const Vec3& crystalY, const Vec3& crystalZ) const;

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

  struct OfPopulation {
    PathAutomaton automaton;
    PathCode code;
    PathTable table;
    std::vector<std::uint64_t> takenBy;  // by state: layers whose pattern takes it
    std::vector<int> layers;             // by state: the first of them
    std::vector<char> kept;              // by state: whether the filter does
    bool hasTilts = false;
  };
  OfPopulation planFor(const Population& population, const PathSettings& settings) const;

  std::vector<OfPopulation> populations_;
  std::vector<std::optional<LayerSettings::TiltRange>> tilts_;  // by layer
  bool hasFilter_;
  int layers_;
  PathRecord record_;
};

/// A crystal's own tilt (rad): the angle of its c axis, of Lowitz crystals of the axis through two opposite edges
/// (crystal +y), from where it is at rest; of crystals in all orientations, of the c axis from the vertical.
double tiltOf(const OrientationSettings& orientation, const Vec3& crystalY, const Vec3& crystalZ);

}  // namespace parhelion
