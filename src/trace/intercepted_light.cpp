// SPDX-License-Identifier: Apache-2.0
#include "trace/intercepted_light.h"

namespace parhelion {

void InterceptedLight::add(const TracedRays& traced) {
  const auto& [queue, exits, members, population, mesh, steps] = traced;
  for (int member = 0; member < members; ++member)
    for (int place = 0; place < queue.count; ++place) {
      const SpectralSample& sample = queue.light[queue.ray(member, place)];
      const double weight = queue.weight[place];
      intercepted_.addUnits(toFixed(weight * sample.light));
      for (int k = 0; k < 3; ++k) xyz_[k].addUnits(toFixed(weight * sample.xyz[k] * perWhite_[k]));
    }
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
