// SPDX-License-Identifier: Apache-2.0
#include "optics/ice.h"

#include <algorithm>

#include "math/overloaded.h"
#include "optics/tables.h"

namespace parhelion {

double iceIndex(double wavelength) {
  if (!(wavelength > kIceIndex.front().wavelength)) return kIceIndex.front().index;
  if (!(wavelength < kIceIndex.back().wavelength)) return kIceIndex.back().index;
  // In visible light the table has a node every 10 nm from its second one on, so the first guess is right.
  const double guess = (wavelength - kIceIndex[1].wavelength) / 10.0 + 1.0;
  auto below = static_cast<std::size_t>(std::clamp(guess, 0.0, static_cast<double>(kIceIndex.size() - 2)));
  while (kIceIndex[below].wavelength > wavelength) --below;
  while (kIceIndex[below + 1].wavelength <= wavelength) ++below;
  const IceNode& a = kIceIndex[below];
  const IceNode& b = kIceIndex[below + 1];
  return a.index + (wavelength - a.wavelength) / (b.wavelength - a.wavelength) * (b.index - a.index);
}

double refractiveIndex(const IceSettings& ice, double wavelength, std::uint64_t bundle) {
  return std::visit(Overloaded{
                        [&](const TabulatedIce&) { return iceIndex(wavelength); },
                        [&](const ConstantIce& constant) { return constant.index; },
                        [&](const IceMixture& mixture) { return mixture.indices[bundle / 2 % mixture.indices.size()]; },
                    },
                    ice);
}

bool differsByBundle(const IceSettings& ice) {
  return std::visit(Overloaded{
                        [](const TabulatedIce&) { return false; },
                        [](const ConstantIce&) { return false; },
                        [](const IceMixture&) { return true; },
                    },
                    ice);
}

}  // namespace parhelion
