// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "recon/hit_map.h"
#include "recon/published/nearest_hits.h"
#include "recon/recon_settings.h"
#include "recon/watch.h"

namespace parhelion {

/// What is known of a picture: values at some of its pixels.
struct KnownValues {
  std::vector<std::size_t> pixels;          // row-major indices, ascending
  std::vector<double> weights;              // relative solid angle that each stands for
  std::vector<std::vector<double>> lights;  // values at these pixels, light per relative solid angle
};

/// The pixels hit, each standing for itself.
KnownValues hitPixels(const HitMap& map);

/// The pixels hit, each standing for its Voronoi cell. An intensity is the pixel's own light per solid angle, a density
/// is its light over the area of the cell.
KnownValues voronoiCells(const HitMap& map, const NearestHits& nearest, HitReading reading);

/// Makes pictures of values at the known pixels, one per kind of light; linear.
using Spread = std::function<std::vector<Raster<double>>(const std::vector<std::vector<double>>&)>;

/// What a picture of light per relative solid angle says where values are known; linear.
using Sample = std::function<std::vector<double>(const Raster<double>&)>;

/// The picture's values at those pixels.
Sample valuesAt(const std::vector<std::size_t>& pixels);

/// Allebach's iteration: x = 0, then x += relaxation * spread(f - sample(x)), 1 + `iterations` times.
/// Watches the residual f - sample(x) of the first light, rms by weight: where it grows twice in a row or by a tenth
/// the iteration ends. The picture of the least residual is the result, and a remark says so if it is not the last one.
/// Sauer & Allebach, Iterative reconstruction of band-limited images from nonuniformly spaced samples, 1987.
Reconstruction allebach(const KnownValues& known, const Sample& sample, const Spread& spread, int iterations,
                        double relaxation, const Watch& watch);

}  // namespace parhelion
