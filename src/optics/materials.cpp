// SPDX-License-Identifier: Apache-2.0
#include "optics/materials.h"

#include "optics/tables.h"

namespace parhelion {

namespace {

const MaterialFacts kIce{IceTable{}, 350.0, 900.0, "Warren & Brandt 2008"};

// In cubic ice molecules have the same neighbours at the same distances as in ice Ih: its index in visible light
// differs by less than what is known of either.
const MaterialFacts kCubicIce{IceTable{}, 350.0, 900.0, "cubic ice as Warren & Brandt 2008"};

// Through the 15 values of Warren 1986, "Optical constants of carbon dioxide ice", Appl. Opt. 25, 2650, from 333 to
// 931 nm, within 5e-4. They are given to 1e-3.
const MaterialFacts kCo2Ice{CauchyIndex{{1.4003, 0.00384, 0.00004}}, 333.0, 931.0, "CO2 ice, Warren 1986"};

// Through the values of Martonchik, Orton & Appleby 1984, "Optical properties of NH3 ice from the far infrared to the
// near ultraviolet", Appl. Opt. 23, 541: 1.449 at 433 nm, 1.423 at 668 nm and 1.408 at 1462 nm within 2e-4, and 1.488
// at 320 nm within 2e-3.
const MaterialFacts kAmmoniaIce{CauchyIndex{{1.4041, 0.00844}}, 320.0, 1462.0, "ammonia ice, Martonchik et al. 1984"};

// Li 1976, "Refractive index of alkali halides and its wavelength and temperature derivatives", J. Phys. Chem. Ref.
// Data 5, 329: sodium chloride at room temperature.
const MaterialFacts kSalt{SellmeierIndex{1.00055,
                                         {{0.19800, 0.050 * 0.050},
                                          {0.48398, 0.100 * 0.100},
                                          {0.38696, 0.128 * 0.128},
                                          {0.25998, 0.158 * 0.158},
                                          {0.08796, 40.50 * 40.50},
                                          {3.17064, 60.98 * 60.98},
                                          {0.30038, 120.34 * 120.34}}},
                          200.0, 30000.0, "sodium chloride, Li 1976"};

// Daimon & Masumura 2007, "Measurement of the refractive index of distilled water from the near-infrared region to the
// ultraviolet region", Appl. Opt. 46, 3811: at 20 degrees Celsius.
const MaterialFacts kWater{SellmeierIndex{1.0,
                                          {{5.684027565e-1, 5.101829712e-3},
                                           {1.726177391e-1, 1.821153936e-2},
                                           {2.086189578e-2, 2.620722293e-2},
                                           {1.130748688e-1, 1.069792721e1}}},
                           182.0, 1129.0, "water, Daimon & Masumura 2007"};

}  // namespace

const MaterialFacts& factsOf(Material material) {
  switch (material) {
    case Material::ice:
      return kIce;
    case Material::cubicIce:
      return kCubicIce;
    case Material::co2Ice:
      return kCo2Ice;
    case Material::ammoniaIce:
      return kAmmoniaIce;
    case Material::salt:
      return kSalt;
    case Material::water:
      return kWater;
  }
  return kIce;
}

}  // namespace parhelion
