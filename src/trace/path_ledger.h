// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "crystal/raypath/path_class.h"
#include "sky/camera.h"
#include "sky/fixed_point.h"
#include "trace/film.h"
#include "trace/path_plan.h"

namespace parhelion {

/// A round part of the sky.
struct SkyRegion {
  Vec3 toCentre;  // unit, world
  double radius;  // rad
};

/// Which light a ledger looks at.
struct PathLedgerScope {
  PathSymmetry symmetry = PathSymmetry::orientation;
  std::optional<SkyRegion> region;     // none: the whole sky
  std::optional<int> layer;            // PathPlan::layerOf(); none: all
  std::optional<CameraSettings> view;  // only what this camera sees; none: all
};

/// How much of the light that leaves the crystals deviated came by which class of raypaths.
class PathLedger : public Film {
 public:
  /// `cloud` must outlive the ledger.
  PathLedger(const Cloud& cloud, const PathLedgerScope& scope);

  bool wantsSequences() const override { return true; }
  int add(const TracedRays& traced) override;
  std::unique_ptr<Film> forThread() override;
  void merge(Film& fromThread) override;

  /// Light that was integrated instead of traced, by one path: where it goes, and which of all it is.
  struct Beam {
    int population;
    PathCode::Words faces;
    int count;  // of faces
    Vec3 toSky;
    double light;
    bool undeviated;
    int layer;
    std::uint64_t point;  // of the quadrature
    int number;           // among those of the point
  };

  /// Adds light of a copy of a quadrature. A copy's light is to be some thousand units, of which it is rounded to 1e-8.
  void add(const Beam& beam);

  /// All light of the copy is there. As a bundle's rays do it goes together; copies are independent.
  void endCopy(double intercepted);

  struct Entry {
    std::string path;  // a pattern
    int population;
    double share, error;                   // of all light in scope, and its standard error
    Vec3 toPeak;                           // unit world vector to where its light is densest on the sky
    std::optional<double> leastDeviation;  // rad
    std::string name;                      // of the halos that patterns call so, with " / " between them; may be empty
  };

  /// Most light first. Refractive indices are those of `wavelength` (nm).
  std::vector<Entry> entries(double wavelength) const;

  /// The largest standard error of a class's share.
  double largestError() const;

  /// Light in scope as a share of all that is intercepted.
  double shareOfIntercepted() const;

  /// The ray that brought most light at once into scope; none if there was none.
  std::optional<std::uint64_t> brightestRay() const;

 private:
  /// Places of the sky where light of a class went, each with the chance of its light: those whose key is highest.
  struct Sample {
    double key;
    Vec3 toSky;
    bool operator<(const Sample& other) const { return key > other.key; }  // the lowest on top of a heap
  };
  static constexpr std::size_t kSamples = 512;

  struct Sums {
    LightTotal light;
    SquareTotal squares, withAll;  // over bundles: of the light squared, and of the light times all light in scope
    std::vector<Sample> samples;   // a heap
  };
  struct OfPopulation {
    PathClasses classes;
    std::map<PathClass, int> numberOf;  // into sums
    std::vector<PathClass> classAt;
    std::vector<Sums> sums;
    std::vector<double> copy;  // light of the copy that is being added, by class
  };
  /// What a path's words stand for, looked up once.
  struct Known {
    PathCode::Words words;
    int count;
    bool operator==(const Known&) const = default;
  };
  struct HashOfKnown {
    std::size_t operator()(const Known& known) const {
      return (known.words.first * 0x9E3779B97F4A7C15u) ^ (known.words.last + static_cast<std::uint64_t>(known.count));
    }
  };

  int classOf(int population, const PathCode::Words& words, int count);
  int numberOf(OfPopulation& own, const PathClass& path);
  double errorOf(const Sums& sums) const;
  void sample(Sums& sums, const Vec3& toSky, double energy, std::uint64_t ray, int order) const;
  bool isInScope(bool undeviated, int layer, const Vec3& toSky) const;
  Vec3 shown(int population, const Vec3& toSky) const;

  const Cloud& cloud_;
  PathLedgerScope scope_;
  std::optional<Camera> camera_;
  std::vector<OfPopulation> populations_;
  std::vector<std::unordered_map<Known, int, HashOfKnown>> known_;  // by population
  LightTotal intercepted_, all_;
  SquareTotal allSquares_;
  double copyAll_ = 0.0;
  double brightest_ = 0.0;
  std::uint64_t brightestRay_ = 0;
};

}  // namespace parhelion
