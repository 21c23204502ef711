// SPDX-License-Identifier: Apache-2.0
#include "recon/published/sky_balance.h"

#include <cmath>

#include "math/portable.h"
#include "parallel/loops.h"

namespace parhelion {
namespace {

constexpr int kLargestRadius = 24;  // of a kernel that is balanced on its own cells
constexpr int kMargin = 2;          // around kernels that reach those at the border: the least ones have little reach
constexpr int kPerCell = 4;         // radii of kernels on coarser cells, in steps of a quarter

// Balancing rounds f -> f (f (K * (share f)))^-w turn an error of eigenvalue e of the kernels into 1 - w (1 + e) times
// itself. These 1 / w are the zeros of the Chebyshev polynomial over 1 + e = 1 to 2: together they leave a 3000th.
constexpr double kRounds[] = {1.5, 1.0245, 1.9755, 1.2061, 1.7939};

/// What is balanced together: pixels, or cells of several. Cells without a kernel keep their factor.
struct Cells {
  PictureShape shape;
  Raster<float> share;
  Raster<const SincKernel*> kernels;
  Raster<float> factors;
};

/// How cells of a level lie over pixels. Outside the picture there is one more row of cells, and as many as a kernel
/// reaches where the picture is wrapped.
struct Axis {
  Axis(int pixels, bool wrapped, int level)
      : size(1 << level),
        pad(wrapped ? kLargestRadius + 1 : 1),
        cells((pixels + size - 1) / size + 2 * pad),
        length(pixels),
        wrap(wrapped) {}

  /// Calls f(pixel) for the pixels of a cell that exist.
  template <class F>
  void forPixels(int cell, const F& f) const {
    for (int i = (cell - pad) * size; i < (cell - pad + 1) * size; ++i) {
      if (wrap) f(((i % length) + length) % length);
      if (!wrap && i >= 0 && i < length) f(i);
    }
  }

  /// The first of the two cells between whose centres a pixel lies, and how far it is from the one to the other.
  std::pair<int, float> place(int pixel) const {
    const double at = (pixel + 0.5) / size - 0.5 + pad;
    const int first = static_cast<int>(at);
    return {first, static_cast<float>(at - first)};
  }

  int size, pad, cells, length;
  bool wrap;
};

bool leaves(int at, int reach, int length, bool wrap) { return !wrap && (at < reach || at + reach >= length); }

/// Where kernelAt(x, y), if there is one, or at most `margin` pixels around it, reaches beyond the picture or to where
/// isOne(x, y) is false.
template <class KernelAt, class IsOne>
Raster<char> reaching(const PictureShape& shape, const KernelAt& kernelAt, int margin, const IsOne& isOne) {
  const SquareSums others(shape, [&](int x, int y) { return isOne(x, y) ? 0 : 1; });
  Raster<char> result(shape.width, shape.height);
  forRows(shape.height, [&](int y) {
    for (int x = 0; x < shape.width; ++x) {
      const SincKernel* kernel = kernelAt(x, y);
      if (kernel == nullptr) continue;
      const int reachX = kernel->reachX() + (shape.width > 1 ? margin : 0);
      const int reachY = kernel->reachY() + (shape.height > 1 ? margin : 0);
      result.at(x, y) = leaves(x, reachX, shape.width, shape.wrapX) || leaves(y, reachY, shape.height, shape.wrapY) ||
                        others.square(x, y, std::max(reachX, reachY)) > 0;
    }
  });
  return result;
}

/// Where kernels are to be balanced: those that reach the border, and those that reach them or nearly. The latter's
/// factors differ from 1 by a thousandth.
template <class KernelAt>
Raster<char> toBalance(const PictureShape& shape, const Raster<float>& share, const KernelAt& kernelAt,
                       KernelFlow flow) {
  const auto whole = [&](int x, int y) { return share.at(x, y) == 1.0F; };
  const Raster<char> first = reaching(shape, kernelAt, 0, whole);
  if (flow == KernelFlow::gather) return first;
  return reaching(shape, kernelAt, kMargin, [&](int x, int y) { return whole(x, y) && first.at(x, y) == 0; });
}

/// Calls f(seen, factor) for the cells that have a kernel: what it sees of `weighted`.
template <class F>
void forKernels(Cells& cells, const Raster<float>& weighted, const F& f) {
  forRows(cells.shape.height, [&](int y) {
    for (int x = 0; x < cells.shape.width; ++x) {
      const SincKernel* kernel = cells.kernels.at(x, y);
      if (kernel == nullptr) continue;
      // Kernels with negative lobes may see next to nothing; none without sees less than its centre does.
      const float own = weighted.at(x, y) > 0.0F ? weighted.at(x, y) : 1.0F;
      const double least = static_cast<double>(kernel->row(0).weights[0] * own);
      f(std::max(sumUnder(*kernel, weighted, x, y, cells.shape), least), cells.factors.at(x, y));
    }
  });
}

/// Sets the factors of the cells that have a kernel.
void balance(Cells& cells, KernelFlow flow) {
  if (flow == KernelFlow::gather) {
    forKernels(cells, cells.share, [](double seen, float& factor) { factor = static_cast<float>(1.0 / seen); });
    return;
  }
  Raster<float> weighted(cells.shape.width, cells.shape.height);
  for (const double round : kRounds) {
    for (std::size_t i = 0; i < weighted.size(); ++i) weighted[i] = cells.share[i] * cells.factors[i];
    forKernels(cells, weighted, [&](double seen, float& factor) {
      const auto f = static_cast<double>(factor);
      factor = static_cast<float>(f * portable::exp(-portable::log(f * seen) / round));
    });
  }
}

/// A level of coarser cells, balanced. Radii are means over the sky of a cell, or around it where it has none.
class CoarseLevel {
 public:
  CoarseLevel(const SkyExtent& sky, const Raster<int>& radii, double lobes, KernelFlow flow, int level)
      : x_(sky.shape.width, sky.shape.wrapX, level), y_(sky.shape.height, sky.shape.wrapY, level) {
    for (int i = 0; i <= kPerCell * kLargestRadius; ++i) {
      kernels_.emplace_back(static_cast<double>(i) / kPerCell, lobes, KernelGain::unit, false, false);
    }
    cells_.shape = {x_.cells, y_.cells};
    cells_.share = cells_.factors = Raster<float>(x_.cells, y_.cells, 1.0F);
    cells_.kernels = Raster<const SincKernel*>(x_.cells, y_.cells);
    const Raster<Sums> sums = sumUp(sky, radii);
    for (std::size_t i = 0; i < sums.size(); ++i)
      cells_.share[i] = sums[i].share / static_cast<float>(x_.size * y_.size);
    chooseKernels(sums, flow);
    balance(cells_, flow);
  }

  /// Interpolated at a pixel.
  float factor(int x, int y) const {
    const auto [i, u] = x_.place(x);
    const auto [j, v] = y_.place(y);
    const float* above = cells_.factors.row(j) + i;
    const float* below = cells_.factors.row(j + 1) + i;
    return (1.0F - v) * ((1.0F - u) * above[0] + u * above[1]) + v * ((1.0F - u) * below[0] + u * below[1]);
  }

 private:
  struct Sums {
    float share = 0.0F, radii = 0.0F, pixels = 0.0F;
  };

  Raster<Sums> sumUp(const SkyExtent& sky, const Raster<int>& radii) const {
    Raster<Sums> sums(x_.cells, y_.cells);
    forRows(y_.cells, [&](int j) {
      for (int i = 0; i < x_.cells; ++i) {
        Sums& cell = sums.at(i, j);
        y_.forPixels(j, [&](int y) {
          x_.forPixels(i, [&](int x) {
            if (sky.share.at(x, y) <= 0.0F) return;
            cell.share += sky.share.at(x, y);
            cell.radii += static_cast<float>(SincBank::rounded(radii.at(x, y)));
            cell.pixels += 1.0F;
          });
        });
      }
    });
    return sums;
  }

  void chooseKernels(const Raster<Sums>& sums, KernelFlow flow) {
    forRows(y_.cells, [&](int j) {
      for (int i = 0; i < x_.cells; ++i) {
        Sums around = sums.at(i, j);
        if (around.pixels == 0.0F) around = neighbours(sums, i, j);
        if (around.pixels == 0.0F) continue;
        const float radius = around.radii / (around.pixels * static_cast<float>(x_.size));
        const int step = std::min(static_cast<int>(std::lround(radius * kPerCell)), kPerCell * kLargestRadius);
        cells_.kernels.at(i, j) = &kernels_[static_cast<std::size_t>(step)];
      }
    });
    const auto kernelAt = [&](int i, int j) { return cells_.kernels.at(i, j); };
    const Raster<char> balanced = toBalance(cells_.shape, cells_.share, kernelAt, flow);
    for (std::size_t i = 0; i < balanced.size(); ++i) {
      if (balanced[i] == 0) cells_.kernels[i] = nullptr;
    }
  }

  Sums neighbours(const Raster<Sums>& sums, int i, int j) const {
    Sums sum;
    for (int y = std::max(j - 1, 0); y < std::min(j + 2, y_.cells); ++y) {
      for (int x = std::max(i - 1, 0); x < std::min(i + 2, x_.cells); ++x) {
        sum.radii += sums.at(x, y).radii;
        sum.pixels += sums.at(x, y).pixels;
      }
    }
    return sum;
  }

  Axis x_, y_;
  std::vector<SincKernel> kernels_;
  Cells cells_;
};

/// The cells on which a kernel is balanced: of 2^level pixels. In signals large kernels are cheap enough for pixels.
int levelOf(int radius, const PictureShape& shape) {
  int level = 0;
  while (radius > (kLargestRadius << level) && shape.width > 1 && shape.height > 1) ++level;
  return level;
}

auto kernelsOf(const SkyExtent& sky, const Raster<int>& radii, const SincBank& bank) {
  return [&](int x, int y) { return sky.share.at(x, y) > 0.0F ? &bank.at(radii.at(x, y)) : nullptr; };
}

}  // namespace

Raster<char> reachesBeyond(const Raster<float>& ones, const SkyExtent& sky, const Raster<int>& radii,
                           const SincBank& bank) {
  return reaching(sky.shape, kernelsOf(sky, radii, bank), 0, [&](int x, int y) { return ones.at(x, y) == 1.0F; });
}

Raster<float> borderFactors(const SkyExtent& sky, const Raster<int>& radii, const SincBank& bank, double lobes,
                            KernelFlow flow) {
  const Raster<char> atBorder = toBalance(sky.shape, sky.share, kernelsOf(sky, radii, bank), flow);
  const int width = sky.shape.width, height = sky.shape.height;
  Cells pixels{sky.shape, sky.share, {width, height}, {width, height, 1.0F}};
  std::vector<char> used(static_cast<std::size_t>(levelOf(std::max(width, height), sky.shape)) + 1);
  for (std::size_t i = 0; i < radii.size(); ++i) {
    if (atBorder[i] != 0) used[static_cast<std::size_t>(levelOf(radii[i], sky.shape))] = 1;
    if (atBorder[i] != 0 && levelOf(radii[i], sky.shape) == 0) pixels.kernels[i] = &bank.at(radii[i]);
  }
  // Coarse cells first: pixels beside those with large kernels need the factors of these.
  for (std::size_t level = used.size() - 1; level > 0; --level) {
    if (used[level] == 0) continue;
    const CoarseLevel coarse(sky, radii, lobes, flow, static_cast<int>(level));
    forRows(height, [&](int y) {
      for (int x = 0; x < width; ++x) {
        if (atBorder.at(x, y) != 0 && levelOf(radii.at(x, y), sky.shape) == static_cast<int>(level)) {
          pixels.factors.at(x, y) = coarse.factor(x, y);
        }
      }
    });
  }
  balance(pixels, flow);
  return pixels.factors;
}

}  // namespace parhelion
