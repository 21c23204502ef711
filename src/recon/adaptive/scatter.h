// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "recon/adaptive/kernel_field.h"

namespace parhelion {

/// The light of a pixel. It has several kinds, such as luminance and colour, which are all filtered in the same way.
template <std::size_t N>
using Light = std::array<float, N>;

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
Grid<Light<N>> scatter(const SkyPyramid& sky, const KernelField& field, const Grid<Light<N>>& light, double hits);

extern template Grid<Light<1>> scatter(const SkyPyramid&, const KernelField&, const Grid<Light<1>>&, double);
extern template Grid<Light<2>> scatter(const SkyPyramid&, const KernelField&, const Grid<Light<2>>&, double);
extern template Grid<Light<4>> scatter(const SkyPyramid&, const KernelField&, const Grid<Light<4>>&, double);

}  // namespace parhelion
