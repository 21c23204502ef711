// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "beam/band_store.h"
#include "beam/crystal_side.h"
#include "beam/pixel_directions.h"
#include "beam/sun_points.h"

namespace parhelion {

/// The sky of crystals whose c axes have any distribution of tilts, with all azimuths and rolls alike.
///
/// For each elevation of the sun, the crystals' azimuths about it have a distribution in each band of alpha. Its
/// product with the light of the band, order by order, summed over all bands, is the sky about the sun.
class TiltSky {
 public:
  /// `tilt` is the inverse of the distribution of tilts (rad). As many rings as cells. `room` (BandStore) must outlive
  /// this.
  TiltSky(const CosineTable& cosines, const BandMesh& mesh, std::vector<SunRow> rows,
          const std::function<double(double)>& tilt, CrystalSide side, std::vector<AlignedVector<float>>& room);

  /// Whether any crystals are in a band.
  bool hasBand(int band) const { return reached_[static_cast<std::size_t>(band)]; }

  /// The highest order that matters in any band.
  double highestOrder() const { return highestOrder_; }

  /// Starts anew, for the rings and the orders of this mesh and so many channels.
  void start(const BandMesh& mesh, int channels);

  /// Adds the light of some bands, in their order. They have these rings and orders, and maybe more.
  void add(const BandLight& light, std::span<const NumberedBand> bands);

  /// What all crystals do.
  const SheetTotals& totals() const { return totals_; }

  /// Light of a pixel: X, Y, Z, or Y alone as the first; the last is Y of the coarse mesh.
  using PixelLight = std::array<float, 4>;

  /// Takes the means of all pixels, times their solid angles. Of a picture whose left half is the mirror image of its
  /// right only that is looked at.
  void expose(const PixelDirections& directions, bool isMirrored, std::vector<PixelLight>& pixels);

 private:
  /// The crystals about one elevation of the sun.
  struct Crystals {
    SunRow sun;
    std::vector<double> shares;   // by band
    AlignedVector<float> orders;  // by band: fine, even and odd; coarse, even and odd
    AlignedVector<float>* sky;    // sums over bands, as bands have them
    AlignedVector<float>* cells;  // by ring and cell, four channels: light per solid angle
  };
  void distribute(const std::function<double(double)>& tilt, CrystalSide side, Crystals& crystals) const;
  void findOrders(Crystals& crystals);
  void synthesise(Crystals& crystals) const;

  const CosineTable& cosines_;
  BandMesh mesh_;
  int room_;  // of all orders
  int channels_ = 0;
  std::optional<RingLayout> layout_;  // of what is summed
  std::vector<Crystals> crystals_;
  AlignedVector<float>* plain_;  // cells of one elevation, before what lies across rings is sharpened
  std::vector<bool> reached_;
  double highestOrder_ = 0.0;
  SheetTotals totals_;
};

}  // namespace parhelion
