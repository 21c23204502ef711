// SPDX-License-Identifier: Apache-2.0
#include "recon/adaptive/kernel_field.h"

#include <algorithm>
#include <utility>

namespace parhelion {

KernelField::KernelField(const SkyPyramid& sky, Grid<KernelSite> pixels) {
  levels_.push_back(std::move(pixels));
  for (int l = 1; l < sky.levels(); ++l) {
    const Grid<KernelSite>& fine = levels_.back();
    const Grid<float>& omega = sky.level(l - 1).omega;
    Grid<KernelSite> coarse(sky.level(l).width(), sky.level(l).height());
    forRows(coarse.height(), [&](int y) {
      for (int x = 0; x < coarse.width(); ++x) {
        KernelSite sum;
        float count = 0.0F;
        for (int fy = 2 * y; fy < std::min(2 * y + 2, fine.height()); ++fy) {
          for (int fx = 2 * x; fx < std::min(2 * x + 2, fine.width()); ++fx) {
            if (omega.at(fx, fy) <= 0.0F) continue;
            const KernelSite& site = fine.at(fx, fy);
            sum.density += site.density;
            sum.shape.p += site.shape.p;
            sum.shape.q += site.shape.q;
            count += 1.0F;
          }
        }
        if (count == 0.0F) continue;
        coarse.at(x, y) = {sum.density / count, {sum.shape.p / count, sum.shape.q / count}};
      }
    });
    levels_.push_back(std::move(coarse));
  }
}

}  // namespace parhelion
