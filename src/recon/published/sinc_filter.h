// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recon/hit_map.h"
#include "recon/published/sinc_bank.h"
#include "recon/published/square_sizes.h"
#include "recon/recon_settings.h"
#include "recon/watch.h"

namespace parhelion {

/// The linear filter of gonzato_marchand.h: sizes, kernels and factors of one hit map, for any light in it.
class SincFilter {
 public:
  /// `samples` is m. The map must outlive this.
  SincFilter(const HitMap& map, const GonzatoMarchandSettings& settings, double samples, const Watch& watch);

  /// Unit gain: light per pixel to light per relative solid angle. Paper gain: values to values. Pixels without any
  /// light cost next to nothing.
  std::vector<Raster<double>> operator()(const std::vector<Raster<double>>& lights) const;

  const Raster<int>& radii() const { return radii_; }
  const SincBank& bank() const { return bank_; }

 private:
  /// The pixels of one row that have light, from left to right.
  struct LitRow {
    std::vector<int> columns;
    std::vector<double> amounts;  // of every kind of light, pixel by pixel
    int reach = 0;                // rows that the highest of their kernels extends to
  };

  std::vector<LitRow> litRows(const std::vector<Raster<double>>& lights) const;
  void balanceSources(LitRow& row, int y, std::size_t kinds) const;
  void scatterRows(const std::vector<LitRow>& sources, int first, int last, std::vector<Raster<double>>& out) const;
  void gatherRow(const std::vector<LitRow>& sources, const std::vector<int>& litAt,
                 const std::vector<Raster<double>>& lights, int y, std::vector<Raster<double>>& out) const;
  double outputGain(int x, int y) const;

  GonzatoMarchandSettings settings_;
  SkyExtent sky_;
  Raster<int> radii_;
  SincBank bank_;
  Raster<float> factors_;     // unit gain: of targets
  Raster<float> countedSky_;  // scatter of unit gain: share of sky times factor
  Raster<char> toBalance_;    // scatter of unit gain: whether a pixel's kernel reaches anything but ones of it
};

}  // namespace parhelion
