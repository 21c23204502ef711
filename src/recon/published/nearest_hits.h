// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "recon/hit_map.h"

namespace parhelion {

/// The Voronoi cells of the pixels that were hit: for every pixel the nearest of them, exact, in linear time. Where
/// several are equally near, all of them: so a picture has the symmetry of its hits.
///
/// Columns first, then the lower envelope of parabolas along each row (Meijster, Roerdink & Hesselink 2000;
/// Felzenszwalb & Huttenlocher 2012), in integers.
class NearestHits {
 public:
  /// The hit pixels are those where the map's first light is above 0.
  explicit NearestHits(const HitMap& map);

  /// The pixels hit, as indices into the map's grids, ascending.
  const std::vector<std::size_t>& pixels() const { return pixels_; }

  /// The hits nearest to a pixel, as indices into pixels(); empty only if there are no hits.
  std::span<const int> of(int x, int y) const {
    const Row& row = rows_[static_cast<std::size_t>(y)];
    const auto i = static_cast<std::size_t>(x);
    return std::span(row.hits).subspan(row.first[i], row.first[i + 1] - row.first[i]);
  }

  /// Sums over each hit's cell, pixels equally near to several being shared: of omega its area.
  std::vector<double> cellSums(const Raster<double>& picture) const;

  /// The picture in which every pixel has the value of its nearest hit, or the mean of those equally near.
  Raster<double> interpolate(const std::vector<double>& values) const;

 private:
  struct Row {
    std::vector<std::size_t> first;  // of a pixel's hits in `hits`, and the end
    std::vector<int> hits;
  };

  int width_, height_;
  std::vector<std::size_t> pixels_;
  std::vector<Row> rows_;
};

}  // namespace parhelion
