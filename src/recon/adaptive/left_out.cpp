// SPDX-License-Identifier: Apache-2.0
#include "recon/adaptive/left_out.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "parallel/loops.h"
#include "recon/adaptive/gates.h"
#include "recon/adaptive/halving.h"

namespace parhelion {
namespace {

/// Share of a correction that is left out.
float leftOutOf(const Raster<float>& gates, std::size_t block) { return gates.size() > 0 ? 1.0F - gates[block] : 1.0F; }

/// How many pixels of each block show sky.
IntegralImage<double> skyPixelsOf(const SkyPyramid& sky) {
  const Raster<float> blocks = gathered<float>(sky.width(), sky.height(), [&](float& block, int x, int y) {
    if (sky.pixels().omega.at(x, y) > 0.0F) block += 1.0F;
  });
  return {blocks.width(), blocks.height(), [&](int x, int y) { return blocks.at(x, y); }};
}

}  // namespace

LeftOut::LeftOut(const SkyPyramid& sky, const KernelField& field)
    : sky_(sky), field_(field), skyPixels_(skyPixelsOf(sky)), squares_(halfOf(sky.width()), halfOf(sky.height())) {}

template <std::size_t N>
void LeftOut::add(const Raster<Light<N>>& wide, const Raster<Light<N>>& narrow, double hits,
                  const Raster<float>& gates) {
  Raster<Correction> correction(sky_.width(), sky_.height());
  forRows(sky_.height(), [&](int y) {
    for (int x = 0; x < sky_.width(); ++x) {
      if (sky_.pixels().omega.at(x, y) <= 0.0F) continue;
      const float perDensity = sky_.wholeOmega().at(x, y) / field_.pixels().at(x, y).density;
      for (std::size_t c = 0; c < 2; ++c) correction.at(x, y)[c] = perDensity * (narrow.at(x, y)[c] - wide.at(x, y)[c]);
    }
  });
  addProduct(1.0F, meanProduct(correction, correction, hits), gates, gates);
  if (coarser_.size() > 0) addProduct(2.0F, meanProduct(coarser_, correction, 4.0 * hits), coarserGates_, gates);
  coarser_ = std::move(correction);
  coarserGates_ = gates;
}

template void LeftOut::add(const Raster<Light<2>>&, const Raster<Light<2>>&, double, const Raster<float>&);
template void LeftOut::add(const Raster<Light<4>>&, const Raster<Light<4>>&, double, const Raster<float>&);

Raster<float> LeftOut::meanOver(const Raster<float>& blocks, double hits) const {
  const IntegralImage<double> sums(blocks.width(), blocks.height(), [&](int x, int y) { return blocks.at(x, y); });
  Raster<float> mean(blocks.width(), blocks.height());
  forRows(mean.height(), [&](int y) {
    for (int x = 0; x < mean.width(); ++x) {
      const int r = windowRadius(field_, x, y, hits);
      const double pixels = skyPixels_.square(x, y, r);
      if (pixels > 0.0) mean.at(x, y) = static_cast<float>(sums.square(x, y, r) / pixels);
    }
  });
  return mean;
}

Raster<float> LeftOut::meanProduct(const Raster<Correction>& a, const Raster<Correction>& b, double hits) const {
  const auto product = [&](float& block, int x, int y) {
    // The halves are (whole + difference) and (whole - difference), so the mixed terms cancel in the mean of both ways.
    const float here = a.at(x, y)[0] * b.at(x, y)[0] - a.at(x, y)[1] * b.at(x, y)[1];
    block += std::clamp(here, -kMostSquare, kMostSquare);
  };
  return meanOver(gathered<float>(sky_.width(), sky_.height(), product), hits);
}

void LeftOut::addProduct(float times, const Raster<float>& product, const Raster<float>& gatesOfA,
                         const Raster<float>& gatesOfB) {
  for (std::size_t i = 0; i < squares_.size(); ++i)
    squares_[i] += times * leftOutOf(gatesOfA, i) * leftOutOf(gatesOfB, i) * std::max(product[i], 0.0F);
}

Raster<float> LeftOut::rootMeanSquare() const {
  Raster<float> result(sky_.width(), sky_.height());
  forRows(result.height(), [&](int y) {
    for (int x = 0; x < result.width(); ++x) {
      if (sky_.pixels().omega.at(x, y) <= 0.0F) continue;
      const float density = field_.pixels().at(x, y).density / sky_.wholeOmega().at(x, y);
      result.at(x, y) = density * std::sqrt(gateAt(squares_, x, y));
    }
  });
  return result;
}

}  // namespace parhelion
