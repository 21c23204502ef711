// SPDX-License-Identifier: Apache-2.0
#include "optics/ice.h"

#include <algorithm>

#include "math/overloaded.h"
#include "optics/tables.h"

namespace parhelion {

double iceIndex(double wavelength) {
  const auto above = std::upper_bound(kIceIndex.begin(), kIceIndex.end(), wavelength,
                                      [](double w, const IceNode& node) { return w < node.wavelength; });
  if (above == kIceIndex.begin()) return kIceIndex.front().index;
  if (above == kIceIndex.end()) return kIceIndex.back().index;
  const IceNode& a = *(above - 1);
  const IceNode& b = *above;
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

}  // namespace parhelion
