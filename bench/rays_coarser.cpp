// SPDX-License-Identifier: Apache-2.0
#include "rays_coarser.h"

namespace parhelion::bench {

Tally coarser(const Tally& tally, int factor) {
  TallyInfo info = tally.info;
  info.camera.width /= factor;
  info.camera.height /= factor;
  Tally coarse(info, tally.colours());
  for (int y = 0; y < tally.height(); ++y)
    for (int x = 0; x < tally.width(); ++x) {
      const int from = y * tally.width() + x, to = y / factor * coarse.width() + x / factor;
      for (int slot = 0; slot < tally.slots(); ++slot)
        coarse.setRaw(to, slot, coarse.raw(to, slot) + tally.raw(from, slot));
    }
  return coarse;
}

}  // namespace parhelion::bench
