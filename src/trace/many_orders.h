// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "crystal/crystal_mesh.h"
#include "trace/cloud.h"
#include "trace/engine.h"
#include "trace/extinction.h"
#include "trace/path_plan.h"
#include "trace/phase_function.h"
#include "trace/slab_depth.h"
#include "trace/slab_settings.h"
#include "trace/slab_stack.h"

namespace parhelion {

/// What falls on a slab and what the slab is made of.
struct SlabContents {
  SunSettings sun;
  IceSettings ice;
  std::vector<PopulationSettings> populations;
  std::vector<HazeSettings> hazes;
};

/// A place in a slab: in which of its layers, counted from the top, and how far down in it, from 0 to 1.
struct SlabPlace {
  std::size_t layer = 0;
  double down = 0.0;
};

/// A way through one layer of a slab, of this optical depth, somewhere on which light is scattered.
struct SlabWay {
  std::size_t layer = 0;
  double from = 0.0, to = 1.0;  // how far down
  double depth = 0.0;
  double meanLeft = 1.0;  // what the way leaves of light, 1 at its start: the mean over the way
};

/// What light meets that goes a direction from somewhere in a layer: of the whole layer, and of those behind it.
struct SlabCrossing {
  double layer, beyond;
  bool goesDown;

  /// From so far down in the layer to where the light leaves the slab.
  double depthFrom(double down) const { return beyond + layer * (goesDown ? 1.0 - down : down); }
};

/// Sunlight in a slab of crystals, and how it is scattered there by one crystal after the other: what walks are drawn
/// from. Immutable; safe to use from many threads.
class ManyOrders {
 public:
  /// `stack` is that of the contents and must outlive it; light may be scattered `orders` times. Throws
  /// std::runtime_error when the engine fails.
  ManyOrders(SlabContents contents, int orders, const SlabStack& stack, Engine engine);

  /// Crystals are proposed in proportion to their surface times a bound of their interception (IncidenceTable), and
  /// taken in proportion to the interception itself.
  struct Kind {
    int population;  // index into the cloud's; of haze, into phases(), behind the cloud's
    bool isHaze;
    double bound;
    double below;  // share of the proposals of this kind and those before it
  };
  const Kind& kindAt(std::size_t layer, double u) const;

  /// Optical depth from a place to where light leaves the slab; SlabDepth says of which light.
  double depthFrom(const SlabPlace& place, const Vec3& direction) const {
    return crossing(place.layer, direction).depthFrom(place.down);
  }

  /// Where light is that has gone through that share of depthFrom().
  SlabPlace onward(SlabPlace place, const Vec3& direction, double share) const;

  /// The part of a flight from `start` that lies in the layer of `place`.
  SlabWay wayTo(const SlabPlace& place, const SlabPlace& start, const Vec3& direction) const;

  /// Share of light scattered into a direction that leaves the slab without being scattered again, as the mean over all
  /// places of the way where it may have been scattered, in proportion to what is scattered at each.
  double meanOut(const SlabWay& way, const SlabCrossing& out) const;

  SlabCrossing crossing(std::size_t layer, const Vec3& direction) const;

  /// A direction of sunlight, for two numbers in (0, 1).
  Vec3 sunlight(double u1, double u2) const;

  /// A wavelength.
  SpectralSample light(double u) const;
  double iceIndex(double wavelength, std::uint64_t walk) const { return refractiveIndex(ice_, wavelength, walk); }

  /// None where there is nothing but haze.
  const Cloud* cloud() const { return cloud_ ? &*cloud_ : nullptr; }
  const Intersectors& engines() const { return engines_; }
  const PathPlan* paths() const { return paths_ ? &*paths_ : nullptr; }
  const std::vector<PhaseFunction>& phases() const { return phases_; }
  const Sun& sun() const { return sun_; }
  const Spectrum& spectrum() const { return spectrum_; }
  int orders() const { return orders_; }

  /// Share of sunlight from the middle of the sun that the slab scatters.
  double scattered() const { return scattered_; }

  /// For films that ask for a mesh where haze has none.
  const CrystalMesh& someMesh() const { return someMesh_; }

 private:
  Sun sun_;
  std::unique_ptr<const SunDisc> disc_;  // none for a point sun
  Spectrum spectrum_;
  IceSettings ice_;
  std::optional<Cloud> cloud_;
  Intersectors engines_;
  std::optional<PathPlan> paths_;
  std::vector<PhaseFunction> phases_;
  struct Layer {
    SlabDepth depth;
    std::vector<Kind> kinds;
  };
  // Where a population's end among the cloud's, which has several for one whose shapes are spread.
  std::vector<std::size_t> populationEnds_;
  std::vector<Kind> kindsOf(const SlabContents& contents, const SlabStack::Layer& layer) const;

  std::vector<Layer> layers_;
  int orders_;
  double scattered_;
  CrystalMesh someMesh_;
};

}  // namespace parhelion
