// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "recon/adaptive/kernel_field.h"

namespace parhelion {

/// The light of a pixel. It has several kinds, such as luminance and colour, which are all filtered in the same way.
template <std::size_t N>
using Light = std::array<float, N>;

/// The first N kinds of light.
template <std::size_t N, std::size_t From>
Raster<Light<N>> firstOf(const Raster<Light<From>>& light) {
  Raster<Light<N>> first(light.width(), light.height());
  for (std::size_t i = 0; i < light.size(); ++i) {
    for (std::size_t c = 0; c < N; ++c) first[i][c] = light[i][c];
  }
  return first;
}

/// Spreads the light of every pixel over a kernel. The kernel has about `hits` hits under it at the pixel that the
/// light comes from. Then the light in every pixel is divided by the solid angle that a kernel of this receiving pixel
/// covers.
///
/// The result is light per relative solid angle (SkyLevel::omega), and 0 outside the sky. It is linear in the light.
/// The first kind of light has a special part: where several pixels share a cell, their kernels are averaged with it as
/// the weight, and pixels that have none of it are skipped.
///
/// Kernels are round or elliptic in pixels. Where the projection distorts, they are not so in the sky. Only the
/// division takes the distortion into account. So a sky of constant radiance comes out constant, up to the border.
template <std::size_t N>
Raster<Light<N>> scatter(const SkyPyramid& sky, const KernelField& field, const Raster<Light<N>>& light, double hits);

extern template Raster<Light<1>> scatter(const SkyPyramid&, const KernelField&, const Raster<Light<1>>&, double);
extern template Raster<Light<2>> scatter(const SkyPyramid&, const KernelField&, const Raster<Light<2>>&, double);
extern template Raster<Light<4>> scatter(const SkyPyramid&, const KernelField&, const Raster<Light<4>>&, double);

}  // namespace parhelion
