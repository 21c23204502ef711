// SPDX-License-Identifier: Apache-2.0
#include "optics/ice.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "math/overloaded.h"
#include "optics/materials.h"
#include "optics/tables.h"

namespace parhelion {

namespace {

/// In visible light Warren & Brandt's table has a node every 10 nm from its second one on.
std::size_t likelyIceNode(double wavelength) {
  const double guess = (wavelength - kIceIndex[1].wavelength) / 10.0 + 1.0;
  return static_cast<std::size_t>(std::clamp(guess, 0.0, static_cast<double>(kIceIndex.size() - 2)));
}

/// One of the values of a table at a wavelength, linear between its nodes, the ends' values beyond. The node before is
/// looked for from `below` on.
template <auto kValue, class Node>
double between(std::span<const Node> nodes, double wavelength, std::size_t below) {
  if (!(wavelength > nodes.front().wavelength)) return nodes.front().*kValue;
  if (!(wavelength < nodes.back().wavelength)) return nodes.back().*kValue;
  while (nodes[below].wavelength > wavelength) --below;
  while (nodes[below + 1].wavelength <= wavelength) ++below;
  const Node& a = nodes[below];
  const Node& b = nodes[below + 1];
  return a.*kValue + (wavelength - a.wavelength) / (b.wavelength - a.wavelength) * (b.*kValue - a.*kValue);
}

template <auto kValue>
double valueOf(const IndexTable& table, double wavelength) {
  const auto after = std::ranges::upper_bound(table.nodes, wavelength, {}, &IndexTable::Node::wavelength);
  const std::ptrdiff_t before = std::max<std::ptrdiff_t>(after - table.nodes.begin() - 1, 0);
  return between<kValue, IndexTable::Node>(table.nodes, wavelength, static_cast<std::size_t>(before));
}

double indexBy(const SellmeierIndex& formula, double wavelength) {
  const double micrometres = 1e-3 * wavelength, square = micrometres * micrometres;
  double sum = formula.constant;
  for (const auto& [strength, resonance] : formula.terms) sum += strength * square / (square - resonance);
  return std::sqrt(sum);
}

double indexBy(const CauchyIndex& formula, double wavelength) {
  const double micrometres = 1e-3 * wavelength, perSquare = 1.0 / (micrometres * micrometres);
  double sum = 0.0;
  for (auto c = formula.coefficients.rbegin(); c != formula.coefficients.rend(); ++c) sum = sum * perSquare + *c;
  return sum;
}

double indexBy(const IndexTable& table, double wavelength) {
  return valueOf<&IndexTable::Node::index>(table, wavelength);
}

double indexBy(const PublishedIndex& published, double wavelength) {
  const MaterialFacts& facts = factsOf(published.material);
  const double within = std::clamp(wavelength, facts.from, facts.to);
  return std::visit(Overloaded{
                        [&](const IceTable&) { return iceIndex(wavelength); },
                        [&](const auto& formula) { return indexBy(formula, within); },
                    },
                    facts.index);
}

}  // namespace

double iceIndex(double wavelength) {
  return between<&IceNode::index, IceNode>(kIceIndex, wavelength, likelyIceNode(wavelength));
}

double refractiveIndex(const IceSettings& ice, double wavelength, std::uint64_t bundle) {
  // As nearly all scenes have it: every ray asks.
  const auto* published = std::get_if<PublishedIndex>(&ice.index);
  if (published && published->material == Material::ice) return iceIndex(wavelength);
  return std::visit(
      Overloaded{
          [](const ConstantIndex& constant) { return constant.index; },
          [&](const IndexMixture& mixture) { return mixture.indices[bundle / 2 % mixture.indices.size()]; },
          [&](const auto& own) { return indexBy(own, wavelength); },
      },
      ice.index);
}

bool knowsAbsorption(const IceSettings& ice) {
  if (ice.k) return true;
  const auto* published = std::get_if<PublishedIndex>(&ice.index);
  const auto* table = std::get_if<IndexTable>(&ice.index);
  return (published && std::holds_alternative<IceTable>(factsOf(published->material).index)) || (table && table->hasK);
}

double imaginaryIndex(const IceSettings& ice, double wavelength) {
  if (ice.k) return *ice.k;
  if (!knowsAbsorption(ice)) return 0.0;
  if (const auto* table = std::get_if<IndexTable>(&ice.index)) return valueOf<&IndexTable::Node::k>(*table, wavelength);
  return between<&IceNode::k, IceNode>(kIceIndex, wavelength, likelyIceNode(wavelength));
}

bool differsByBundle(const IceSettings& ice) { return std::holds_alternative<IndexMixture>(ice.index); }

bool isWithoutDispersion(const IceSettings& ice) {
  return std::holds_alternative<ConstantIndex>(ice.index) || differsByBundle(ice);
}

}  // namespace parhelion
