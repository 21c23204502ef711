// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace parhelion {

/// Fine particles in the air. Their vertical optical depth is beta (wavelength / 1000 nm)^-alpha (Angstrom 1929).
struct AerosolSettings {
  double beta = 0.03;      // of clean air 0.02-0.05
  double alpha = 1.3;      // larger for smaller particles
  double albedo = 0.95;    // share of what they take from a beam that they scatter, [0, 1]
  double g = 0.7;          // mean cosine of the scattering angle, Henyey-Greenstein, (-1, 1)
  double height = 1500.0;  // m, in which their density falls to 1/e
};

/// The air around the cloud, and the ground below it.
struct SkySettings {
  bool air = false;      // whether there is any: pictures are in absolute units then
  double ozone = 300.0;  // Dobson units
  AerosolSettings aerosol;
  double ground = 0.15;  // albedo of the ground, at sea level; the same at every wavelength
};

struct ObserverSettings {
  double altitude = 0.0;  // m above sea level
};

}  // namespace parhelion
