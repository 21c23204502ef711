// SPDX-License-Identifier: Apache-2.0
#include "recon/adaptive/kernel_field.h"

#include <utility>

#include "recon/adaptive/halving.h"

namespace parhelion {
namespace {

struct SiteSum : KernelSite {
  float count = 0.0F;
};

/// The mean sites over the sky of cells of 2 x 2.
Raster<KernelSite> meanSites(const Raster<KernelSite>& fine, const Raster<float>& omega) {
  const Raster<SiteSum> sums = gathered<SiteSum>(fine.width(), fine.height(), [&](SiteSum& sum, int x, int y) {
    if (omega.at(x, y) <= 0.0F) return;
    const KernelSite& site = fine.at(x, y);
    sum.density += site.density;
    sum.shape.p += site.shape.p;
    sum.shape.q += site.shape.q;
    sum.count += 1.0F;
  });
  Raster<KernelSite> means(sums.width(), sums.height());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const SiteSum& sum = sums[i];
    if (sum.count > 0.0F) means[i] = {sum.density / sum.count, {sum.shape.p / sum.count, sum.shape.q / sum.count}};
  }
  return means;
}

}  // namespace

KernelField::KernelField(const SkyPyramid& sky, Raster<KernelSite> pixels) {
  levels_.push_back(std::move(pixels));
  for (int l = 1; l < sky.levels(); ++l) levels_.push_back(meanSites(levels_.back(), sky.level(l - 1).omega));
}

}  // namespace parhelion
