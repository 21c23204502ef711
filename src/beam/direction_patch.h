// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "beam/angle_bins.h"
#include "beam/light_class.h"
#include "beam/scatter_scene.h"
#include "beam/wanted_tracer.h"

namespace parhelion {

/// Directions of light in the crystal's frame, from azimuths phi0 to phi1 and angles zeta0 to zeta1 from -c (rad).
struct PatchBounds {
  double phi0, phi1, zeta0, zeta1;

  double area() const { return (phi1 - phi0) * (zeta1 - zeta0); }
};

/// Light of all directions of a patch in randomly oriented prisms: traced at the nodes of a grid, linear between them.
class DirectionPatch {
 public:
  static constexpr int kCells = 16;  // along each side; even

  /// `allDirections`: solid angle of all patches. Light of less than `cutShare` is not cut up (PrismTracer).
  /// `detailed`: totals have path and orders, too. The scene must outlive this.
  DirectionPatch(const ScatterScene& scene, double allDirections, double cutShare, bool detailed);

  /// The light of a patch over the scattering angle, undeviated light apart.
  struct Bins {
    AngleBins fine;    // from all nodes
    AngleBins coarse;  // from every second one
    AngleBins other;   // the latter with other indices of continuous light; not of lines
  };

  /// Traces the light of a patch and adds it to bins. Of continuous light each patch has indices of its own by its
  /// `number`.
  void add(const PatchBounds& bounds, int number, Bins& bins);

  /// The sums over the patch, from every `step`th node.
  ScatterTotals totals(int step) const;

 private:
  static constexpr int kSide = kCells + 1, kNodes = kSide * kSide;
  using Four = Lanes<4>::Real;
  static constexpr int kRoom = (kNodes + 3) / 4 * 4;
  using Row = std::array<double, kRoom>;

  /// What meets the exit face at each node, per azimuth and angle from c; for each index that is traced.
  struct Class {
    int number;
    std::vector<Row> met;

    LightClass of() const { return LightClass(number); }
  };
  /// The same for one index, and what becomes of it.
  struct Seen {
    Row energy, density, angle, excess, cosine;
    Row bend;  // how far angles beside it stray from linear ones (rad)
  };
  /// A corner of a triangle.
  struct Corner {
    double phi, zeta, energy, density, angle, excess;
  };
  /// Light of a class between two indices.
  struct Exit {
    LightClass of;
    const IceLight::Segment& light;
    const Seen &from, &to;
    std::size_t first;  // of its places, for the first quad of nodes
  };

  Class& classOf(int number);
  void traceNode(int node);
  void takeLight(int node, double perAngles, std::size_t tracer);
  void addClass(const Class& c, double start, Bins& bins);
  void see(const Class& c, const IceLight::Sample& sample, Seen& seen) const;
  void count(const Exit& exit);
  bool isWeak(const Exit& exit) const;
  void addNodes(const Exit& exit, Bins& bins) const;

  /// The patch's light where it meets faces that it may leave by.
  double met() const;
  static void findBends(Seen& seen);
  /// Adds a triangle at an index `at` so far on its way, in as many parts as are worth it.
  void addPart(AngleBins& bins, const Exit& exit, double at, const Corner& a, const Corner& b, const Corner& c,
               double area, int depth) const;
  /// Each quad of nodes takes light of one index.
  template <bool isLine>
  void addQuads(AngleBins& bins, const Exit& exit, int step) const;
  Corner corner(const Exit& exit, std::size_t node, double at) const;
  Corner seen(const Exit& exit, double phi, double zeta, double energy, double at) const;

  /// What a bin of such a width has at an angle if light is spread evenly, more or less.
  double evenLight(double angle, double width) const;

  const ScatterScene& scene_;
  double allDirections_;
  std::vector<WantedTracer> tracers_;  // by prism, in each by what is wanted, and then by index
  std::vector<double> perShadow_;      // of each but for the index: crystals, as one over their mean shadow
  PrismLight light_;
  PatchBounds bounds_{};
  std::array<Row, 3> lightDir_;
  std::array<ScatterTotals, kNodes> totals_;
  std::array<int, kLightClasses> slot_;
  std::vector<Class> classes_;
  int used_ = 0;              // of classes_
  double strong_ = 0.0;       // light of a class in the patch that is added triangle by triangle
  std::array<Seen, 2> seen_;  // at successive indices
};

}  // namespace parhelion
