// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <optional>
#include <string_view>
#include <utility>
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

/// What crystals may be made of, by indices that were published; see optics/materials.h.
enum class Material { ice, cubicIce, co2Ice, ammoniaIce, salt, water };

constexpr std::string_view nameOf(Material value) {
  switch (value) {
    case Material::ice:
      return "warren-brandt";
    case Material::cubicIce:
      return "cubic-ice";
    case Material::co2Ice:
      return "co2-ice";
    case Material::ammoniaIce:
      return "ammonia-ice";
    case Material::salt:
      return "salt";
    case Material::water:
      return "water";
  }
  return {};
}

/// The index of a material.
struct PublishedIndex {
  Material material = Material::ice;
};

/// One index at every wavelength.
struct ConstantIndex {
  double index = 1.31;
};

/// Several indices, each at every wavelength: rays take them in turn.
struct IndexMixture {
  std::vector<double> indices;
};

/// Sellmeier's formula, n^2 = constant + sum of strength w^2 / (w^2 - resonance), w in micrometres.
struct SellmeierIndex {
  struct Term {
    double strength;
    double resonance;  // um^2
  };
  double constant = 1.0;
  std::vector<Term> terms;
};

/// Cauchy's formula, n = c0 + c1 / w^2 + c2 / w^4 + ..., w in micrometres.
struct CauchyIndex {
  std::vector<double> coefficients;
};

/// Measured values, linear in wavelength between, the ends' values beyond.
struct IndexTable {
  struct Node {
    double wavelength;  // nm, rising
    double index;
    double k = 0.0;  // the imaginary part of the index
  };
  std::vector<Node> nodes;  // at least one
  bool hasK = false;        // whether k was measured
};

using IndexSettings =
    std::variant<PublishedIndex, ConstantIndex, IndexMixture, SellmeierIndex, CauchyIndex, IndexTable>;

/// What all crystals of a scene are made of.
struct IceSettings {
  IndexSettings index;
  bool absorbs = false;                    // whether light is absorbed on its way through crystals
  std::optional<double> k = std::nullopt;  // imaginary part of the index, the same at every wavelength; else its own

  IceSettings() = default;
  template <class Index>
  requires std::constructible_from<IndexSettings, Index> IceSettings(Index own)
      : index(std::move(own)) {}  // NOLINT: indices are ice
};

}  // namespace parhelion
