// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "math/conventions.h"

namespace parhelion {

/// A continuous spectrum, as the 1931 observer sees it: sunlight, equal energy, or an illuminant of the CIE.
struct ContinuousSpectrum {
  enum class Source { extraterrestrial, airMass1_5, equal, a, d50, d55, d65, d75, e } source = Source::extraterrestrial;
  // The share that is left of it at each nanometre of the visible (optics/tables.h), [0, 1]; all where it is empty.
  std::vector<double> transmittance = {};
};

constexpr std::string_view nameOf(ContinuousSpectrum::Source value) {
  switch (value) {
    case ContinuousSpectrum::Source::extraterrestrial:
      return "sun";
    case ContinuousSpectrum::Source::airMass1_5:
      return "sun-am1.5";
    case ContinuousSpectrum::Source::equal:
      return "equal";
    case ContinuousSpectrum::Source::a:
      return "A";
    case ContinuousSpectrum::Source::d50:
      return "D50";
    case ContinuousSpectrum::Source::d55:
      return "D55";
    case ContinuousSpectrum::Source::d65:
      return "D65";
    case ContinuousSpectrum::Source::d75:
      return "D75";
    case ContinuousSpectrum::Source::e:
      return "E";
  }
  return {};
}

/// One wavelength: luminance only, no colour.
struct MonochromaticSpectrum {
  double wavelength = 550.0;  // nm
};

/// Spectral lines, coloured by the 1931 observer.
struct LineSpectrum {
  std::vector<double> wavelengths;   // nm
  std::vector<double> weights = {};  // their energies, in any unit; empty where all are alike
};

/// The thermal light of a black body, continuous.
struct BlackBody {
  double temperature = 5772.0;  // kelvin
};

using SpectrumSettings = std::variant<ContinuousSpectrum, MonochromaticSpectrum, LineSpectrum, BlackBody>;

struct SunSettings {
  double elevation = radians(20.0);  // rad, above the horizon, [-pi/2, pi/2]
  double diameter = radians(0.533);  // rad, across the disc; 0 is a point sun
  SpectrumSettings spectrum = ContinuousSpectrum{};
  bool visible = false;                          // draw the undeviated light into the image
  std::optional<double> azimuth = std::nullopt;  // rad, clockwise from north, where it is known
};

/// Warren & Brandt's table of the refractive index of ice.
struct TabulatedIce {};

/// One index at every wavelength.
struct ConstantIce {
  double index = 1.31;
};

/// Several indices, each at every wavelength: rays take them in turn.
struct IceMixture {
  std::vector<double> indices;
};

using IceSettings = std::variant<TabulatedIce, ConstantIce, IceMixture>;

}  // namespace parhelion
