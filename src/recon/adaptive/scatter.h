// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "recon/adaptive/kernel_field.h"

namespace parhelion {

/// What a pixel got, in several kinds of light that are filtered alike.
template <std::size_t N>
using Light = std::array<float, N>;

/// Spreads every pixel's light over a kernel under which about `hits` hits lie where the light comes from, and divides
/// by the solid angle that a kernel of the receiving pixel sees: light per relative solid angle (SkyLevel::omega), 0
/// outside the sky. Linear in the light. Light of the first kind places kernels that share a cell, and pixels without
/// any of it are passed over.
///
/// Kernels are round or elliptic in pixels: where the projection distorts, they are not so in the sky. Only the
/// division knows the distortion, so that a sky of constant radiance comes out constant, up to the border.
template <std::size_t N>
Raster<Light<N>> scatter(const SkyPyramid& sky, const KernelField& field, const Raster<Light<N>>& light, double hits);

extern template Raster<Light<1>> scatter(const SkyPyramid&, const KernelField&, const Raster<Light<1>>&, double);
extern template Raster<Light<2>> scatter(const SkyPyramid&, const KernelField&, const Raster<Light<2>>&, double);
extern template Raster<Light<4>> scatter(const SkyPyramid&, const KernelField&, const Raster<Light<4>>&, double);

}  // namespace parhelion
