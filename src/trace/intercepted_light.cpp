// SPDX-License-Identifier: Apache-2.0
#include "trace/intercepted_light.h"

#include "sky/fixed_point.h"

namespace parhelion {

void InterceptedLight::add(const TracedRays& traced) {
  const auto& [queue, exits, members, mesh, steps] = traced;
  for (int member = 0; member < members; ++member)
    for (int place = 0; place < queue.count; ++place)
      addFixed(intercepted_, toFixed(queue.weight[place] * queue.light[queue.ray(member, place)].light));
  for (int exit = 0; exit < exits.count; ++exit)
    if (exits.undeviated[exit] != 0.0)
      addFixed(undeviated_, toFixed(exits.energy[exit] * queue.light[static_cast<int>(exits.ray[exit])].light));
}

void InterceptedLight::addTo(TallyInfo& info, int images) const {
  for (int image = 0; image < images; ++image) {
    addFixed(info.intercepted, intercepted_);
    addFixed(info.undeviated, undeviated_);
  }
}

}  // namespace parhelion
