// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>

#include "picture/raster.h"

namespace parhelion {

/// The smallest number not below `atLeast` that has no prime factor above 5: a fast length of a Fourier transform.
int fastLength(int atLeast);

/// Signed frequency of index i of a transform of n values, in turns per n: -n/2 < k <= n/2.
inline int signedFrequency(int i, int n) { return 2 * i <= n ? i : i - n; }

/// Where the signed frequency k is found among n.
inline int frequencyIndex(int k, int n) { return k >= 0 ? k : k + n; }

/// In-place discrete Fourier transform in both directions, for any size, not scaled: forward and back again multiplies
/// by the number of values.
void fourier(Raster<std::complex<double>>& values, bool inverse);

/// The same periodic picture on another number of points: its trigonometric polynomial of the frequencies that both
/// grids hold. Exact for polynomials both can hold; an axis of equal length keeps its values.
Raster<double> resample(const Raster<double>& picture, int width, int height);

}  // namespace parhelion
