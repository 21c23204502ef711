// SPDX-License-Identifier: Apache-2.0
#include "beam/wanted_tracer.h"

#include <algorithm>

namespace parhelion {

WantedTracer::WantedTracer(const PrismSection& section, double length, double index, double cutShare, bool detailed,
                           const WantedPaths* wanted)
    : all_(section, length, index, cutShare, detailed), detailed_(detailed), wanted_(wanted) {
  if (!wanted) return;
  others_ = wanted->shortOthers();
  pieces_.emplace(section, length, index, cutShare, detailed, others_ ? *others_ : *wanted);
}

void WantedTracer::meetOutside(const Vec3& lightDir, PrismLight& light) const {
  all_.meetOutside(lightDir, light);
  if (!wanted_) return;
  for (int face = 0; face < kPrismFaces; ++face)
    if (!wanted_->isWanted(wanted_->next(WantedPaths::kStart, face))) light.mirrored[face] = 0.0;
}

void WantedTracer::trace(const Vec3& lightDir, PrismLight& light) {
  if (!wanted_ || others_ || detailed_) all_.trace(lightDir, light);
  if (!wanted_) return;
  meetOutside(lightDir, light);
  if (!others_) return pieces_->trace(lightDir, light);
  rest_.shadow = light.shadow;
  rest_.reflectance = light.reflectance;
  pieces_->trace(lightDir, rest_);
  // What rounding leaves of light of which none is wanted may be less than nothing.
  for (std::size_t entry = 0; entry < kPrismFaces; ++entry)
    for (std::size_t element = 0; element < kPrismElements; ++element)
      for (std::size_t exit = 0; exit < kPrismFaces; ++exit) {
        double& own = light.arrived[entry][element][exit];
        own = std::max(0.0, own - rest_.arrived[entry][element][exit]);
      }
  if (!detailed_) return;
  for (std::size_t order = 0; order < light.byOrder.size(); ++order)
    light.byOrder[order] = std::max(0.0, light.byOrder[order] - rest_.byOrder[order]);
}

}  // namespace parhelion
