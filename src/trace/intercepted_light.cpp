// SPDX-License-Identifier: Apache-2.0
#include "trace/intercepted_light.h"

namespace parhelion {

void InterceptedLight::add(const TracedRays& traced) {
  const auto& [queue, exits, members, population, mesh, steps] = traced;
  ManyAmounts light, x, y, z;
  const Vec3 perWhite = perWhite_;
  for (int member = 0; member < members; ++member)
    for (int place = 0; place < queue.count; ++place) {
      const SpectralSample& sample = queue.light[queue.ray(member, place)];
      const double weight = queue.weight[place];
      const FixedLight units = toFixedLight(weight * sample.xyz, perWhite);
      x.add(units.x);
      y.add(units.y);
      z.add(units.z);
      light.add(sample.light == sample.xyz.y ? units.y : toFixed(weight * sample.light));
    }
  intercepted_.merge(light.total());
  xyz_[0].merge(x.total());
  xyz_[1].merge(y.total());
  xyz_[2].merge(z.total());
  for (int exit = 0; exit < exits.count; ++exit)
    if (exits.undeviated[exit] != 0.0)
      undeviated_.addUnits(toFixed(exits.energy[exit] * queue.light[static_cast<int>(exits.ray[exit])].light));
}

void InterceptedLight::addTo(TallyInfo& info) const {
  for (int image = 0; image < info.images(); ++image) {
    info.intercepted.merge(intercepted_);
    info.undeviated.merge(undeviated_);
    for (int k = 0; k < 3; ++k) info.interceptedXyz[k].merge(xyz_[k]);
  }
}

void InterceptedLight::clear() {
  intercepted_ = undeviated_ = {};
  xyz_ = {};
}

}  // namespace parhelion
