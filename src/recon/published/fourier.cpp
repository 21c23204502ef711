// SPDX-License-Identifier: Apache-2.0
#include "recon/published/fourier.h"

#include "parallel/loops.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include <kissfft/kissfft.hh>

namespace parhelion {

namespace {

using Complex = std::complex<double>;
using Plan = kissfft<double>;

void transformRows(Raster<Complex>& values, bool inverse) {
  const Plan plan(static_cast<std::size_t>(values.width()), inverse);
  forRows(values.height(), [&](int y) {
    const Plan own = plan;  // a plan has a scratch buffer: no two threads may share it
    const std::vector<Complex> in(values.row(y), values.row(y) + values.width());
    own.transform(in.data(), values.row(y));
  });
}

void transformColumns(Raster<Complex>& values, bool inverse) {
  const auto height = static_cast<std::size_t>(values.height());
  const Plan plan(height, inverse);
  forRows(values.width(), [&](int x) {
    const Plan own = plan;
    std::vector<Complex> in(height), out(height);
    for (std::size_t y = 0; y < height; ++y) in[y] = values.at(x, static_cast<int>(y));
    own.transform(in.data(), out.data());
    for (std::size_t y = 0; y < height; ++y) values.at(x, static_cast<int>(y)) = out[y];
  });
}

// Whether grids of n and m points both hold the frequency k. The highest of an even number is not told from its
// negative, so it counts only where nothing changes.
bool heldByBoth(int k, int n, int m) { return n == m || 2 * std::abs(k) < std::min(n, m); }

}  // namespace

int fastLength(int atLeast) {
  for (int n = std::max(atLeast, 1);; ++n) {
    int rest = n;
    for (const int p : {2, 3, 5}) {
      while (rest % p == 0) rest /= p;
    }
    if (rest == 1) return n;
  }
}

void fourier(Raster<Complex>& values, bool inverse) {
  if (values.width() > 1) transformRows(values, inverse);
  if (values.height() > 1) transformColumns(values, inverse);
}

Raster<double> resample(const Raster<double>& picture, int width, int height) {
  if (width == picture.width() && height == picture.height()) return picture;
  Raster<Complex> from(picture.width(), picture.height());
  for (std::size_t i = 0; i < from.size(); ++i) from[i] = picture[i];
  fourier(from, false);

  Raster<Complex> to(width, height);
  for (int j = 0; j < height; ++j) {
    const int ky = signedFrequency(j, height);
    if (!heldByBoth(ky, height, picture.height())) continue;
    for (int i = 0; i < width; ++i) {
      const int kx = signedFrequency(i, width);
      if (!heldByBoth(kx, width, picture.width())) continue;
      to.at(i, j) = from.at(frequencyIndex(kx, picture.width()), frequencyIndex(ky, picture.height()));
    }
  }
  fourier(to, true);

  Raster<double> result(width, height);
  const double scale = 1.0 / static_cast<double>(from.size());
  for (std::size_t i = 0; i < to.size(); ++i) result[i] = to[i].real() * scale;
  return result;
}

}  // namespace parhelion
