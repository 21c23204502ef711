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

  /// Light of less than `cutShare` is not cut up (PrismTracer). `detailed`: totals have path and orders, too. The scene
  /// must outlive this.
  DirectionPatch(const ScatterScene& scene, double cutShare, bool detailed);

  /// The light of a patch over the scattering angle, undeviated light apart.
  struct Bins {
    AngleBins fine;    // from all nodes
    AngleBins coarse;  // from every second one
    AngleBins other;   // the latter with other samples of continuous light; of lines the same
  };

  /// Traces the light of a patch and adds it to bins. Of continuous light each patch has samples of its own by its
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
  };
  /// A corner of a triangle.
  struct Corner {
    double phi, zeta, energy, density, angle, excess;
  };
  /// The class and the index whose triangles are being added.
  struct Exit {
    LightClass of;
    RelativeIndex index;
    Tristimulus xyz;
  };

  Class& classOf(int number);
  void traceNode(int node);
  void takeLight(int node, double perAngles, std::size_t tracer);
  void addClass(const Class& c, double start, Bins& bins);
  void see(const Class& c, const IceLight::Sample& sample);
  /// `light`: Y of a unit of it.
  void count(const Class& c, double light);
  bool isWeak() const;

  /// The patch's light where it meets faces that it may leave by.
  double met() const;
  void addTriangles(AngleBins& bins, const Exit& exit, int step) const;
  void addTriangle(AngleBins& bins, const Exit& exit, const Corner& a, const Corner& b, const Corner& c, double area,
                   int depth) const;
  Corner corner(int row, int column) const;

  const ScatterScene& scene_;
  std::vector<WantedTracer> tracers_;  // by prism, in each by what is wanted, and then by index
  std::vector<double> perShadow_;      // of each but for the index: crystals, as one over their mean shadow
  PrismLight light_;
  PatchBounds bounds_{};
  std::array<Row, 3> lightDir_;
  std::array<ScatterTotals, kNodes> totals_;
  std::array<int, kLightClasses> slot_;
  std::vector<Class> classes_;
  int used_ = 0;         // of classes_
  double strong_ = 0.0;  // light of a class in the patch that is added triangle by triangle
  Seen seen_;
  std::vector<IceLight::Sample> samples_;
};

}  // namespace parhelion
