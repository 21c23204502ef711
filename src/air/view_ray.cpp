// SPDX-License-Identifier: Apache-2.0
#include "air/view_ray.h"

#include <cmath>

namespace parhelion {

ViewRay::ViewRay(const Atmosphere& air, const AirSpectrum& spectrum, const RayPlace& from, int steps)
    : groundDistance_(from.distanceToGround()), transmittance_() {
  const double length = meetsGround() ? groundDistance_ : from.distanceUpTo(kAirTop);
  transmittance_.fill(1.0);
  steps_.reserve(static_cast<std::size_t>(steps));
  for (int i = 0; i < steps; ++i) {
    const auto at = [&](double u) { return length * u * u / (double(steps) * steps); };
    const double ds = at(i + 1.0) - at(i);
    Step step{at(i + 0.5), from.after(at(i + 0.5)).altitude(), at(i), at(i + 1.0), {}, {}};
    const OfAir density = air.densities(step.altitude);
    Spectral depth{};
    spectrum.addDepth({density.rayleigh * ds, density.ozone * ds, density.aerosol * ds}, depth);
    const Spectral through = attenuation(depth);
    for (std::size_t b = 0; b < kBands; ++b) {
      // The integral of exp(-depth) over the step, whose air is that of its middle.
      constexpr double kThin = 1e-5;  // below which the step's own extinction is nothing
      const double seen = transmittance_[b] * (depth[b] > kThin ? (1.0 - through[b]) / depth[b] : 1.0) * ds;
      step.rayleigh[b] = seen * spectrum.rayleigh[b] * density.rayleigh;
      step.aerosol[b] = seen * spectrum.scattering[b] * density.aerosol;
      transmittance_[b] *= through[b];
    }
    steps_.push_back(step);
  }
}

}  // namespace parhelion
