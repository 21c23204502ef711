// SPDX-License-Identifier: Apache-2.0
#pragma once

// The keys of [ice]; see scene_keys.h.

#include <optional>
#include <vector>

#include "scene/kinds.h"
#include "scene/table_kinds.h"

namespace parhelion {

/// An index as a table.
struct IndexKeys {
  std::optional<double> constant = std::nullopt;
  std::vector<SellmeierIndex::Term> sellmeier = {};
  std::vector<double> cauchy = {};
  IndexTable table = {};
};

template <class Visitor>
void visitKeys(Visitor& v, IndexKeys& index) {
  v.key("sellmeier", kinds::SellmeierTerms{}, index.sellmeier,
        "Sellmeier's formula by its terms [B, C], C in square micrometres: n^2 = constant + sum of B w^2 / (w^2 - C), "
        "w the wavelength in micrometres.");
  v.key("constant", kinds::Optional{kinds::Number{{0, 100}}}, index.constant,
        "The constant of Sellmeier's formula; 1 when left out.");
  v.key("cauchy", kinds::CauchyCoefficients{}, index.cauchy,
        "Cauchy's formula by its coefficients [A, B, C, ...]: n = A + B / w^2 + C / w^4 + ..., w in micrometres.");
  v.key("table", kinds::IndexRows{}, index.table,
        "Measured values: a list of [wavelength in nm, n] or [wavelength in nm, n, k], in rising order; linear between "
        "them, the ends' values beyond. The name of a .csv file in the place of this table is the same.");
}

template <class Visitor>
void visitKeys(Visitor& v, IceSettings& ice) {
  v.key(
      "index", kinds::Index{}, ice.index,
      "Refractive index: the name of a material - \"warren-brandt\" (ice), \"cubic-ice\", \"co2-ice\", "
      "\"ammonia-ice\", \"salt\", \"water\" -; a number, the same at every wavelength; a list of numbers, of which "
      "rays take each in turn; a formula, { sellmeier = [[B, C], ...] } or { cauchy = [A, B, ...] }; or the name of a "
      ".csv file beside the scene, whose lines are wavelength in nm,n or wavelength,n,k.");
  v.key("absorption", kinds::Absorption{}, ice,
        "Whether crystals absorb light, by the imaginary part k of the index, which ice has, and tables may; or k "
        "itself, the same at every wavelength. Populations need a 'size' then.");
}

}  // namespace parhelion
