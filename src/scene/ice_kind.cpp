// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include "math/overloaded.h"
#include "scene/index_files.h"
#include "scene/scene_keys.h"

namespace parhelion::kinds {

namespace {

constexpr Range kCoefficient{-1e6, 1e6};
constexpr int kMostCoefficients = 16;
// Beyond, Fresnel's formulas for transparent media are no good any more.
constexpr Range kImaginary{0.0, 0.1};

bool readMixture(const Value& in, const toml::array& list, IndexSettings& out) {
  IndexMixture mixture;
  for (const toml::node& element : list) {
    const Value one{element, in.key, in.complaints};
    const auto index = one.numberIn(kIndexRange);
    if (!index) return one.mustBe(std::string("a list of numbers ").append(kIndexRange.text()) + " here");
    mixture.indices.push_back(*index);
  }
  out = std::move(mixture);
  return true;
}

bool readKeys(const Value& in, const toml::table& table, IndexSettings& out) {
  TableReader reader(table, "the index", in.complaints);
  IndexKeys keys;
  visitKeys(reader, keys);
  if (!reader.rejectUnknown()) return false;
  int ways = 0;
  for (const char* way : {"sellmeier", "cauchy", "table"}) {
    if (reader.rejected(way)) return false;
    ways += reader.has(way);
  }
  if (ways != 1)
    return in.reject(
        "an index needs one of 'sellmeier', 'cauchy' and 'table'",
        "{ sellmeier = [[0.7, 0.01]] }, { cauchy = [1.3, 0.003] } or { table = [[400, 1.32], [700, 1.31]] }");
  if (reader.has("constant") && !reader.has("sellmeier")) {
    reader.reject("constant", "'constant' belongs to 'sellmeier'", "leave it out");
    return false;
  }
  if (reader.rejected("constant")) return false;
  if (reader.has("sellmeier")) out = SellmeierIndex{keys.constant.value_or(SellmeierIndex{}.constant), keys.sellmeier};
  if (reader.has("cauchy")) out = CauchyIndex{keys.cauchy};
  if (reader.has("table")) out = keys.table;
  return true;
}

}  // namespace

bool SellmeierTerms::read(const Value& in, std::vector<SellmeierIndex::Term>& out) const {
  const toml::array* list = in.node.as_array();
  const auto refuse = [&](const Value& at) {
    return at.mustBe("a list of 1 to " + std::to_string(kMostCoefficients) + " pairs of numbers [B, C]",
                     "C is in square micrometres: the square of a resonance's wavelength");
  };
  if (!list || list->empty() || list->size() > kMostCoefficients) return refuse(in);
  for (const toml::node& element : *list) {
    const Value one{element, in.key, in.complaints};
    const auto pair = one.numbersIn(2, 2, kCoefficient);
    if (!pair) return refuse(one);
    out.push_back({pair->at(0), pair->at(1)});
  }
  return true;
}

Json SellmeierTerms::schema() const {
  return listSchema(listSchema(numberSchema(kCoefficient), 2, 2), 1, kMostCoefficients);
}

bool CauchyCoefficients::read(const Value& in, std::vector<double>& out) const {
  auto numbers = in.numbersIn(1, kMostCoefficients, kCoefficient);
  if (!numbers) return in.mustBe("a list of 1 to " + std::to_string(kMostCoefficients) + " numbers [A, B, C, …]");
  out = *std::move(numbers);
  return true;
}

Json CauchyCoefficients::schema() const { return listSchema(numberSchema(kCoefficient), 1, kMostCoefficients); }

bool IndexRows::read(const Value& in, IndexTable& out) const {
  const toml::array* list = in.node.as_array();
  std::vector<double> before;
  const auto refuse = [&](const Value& at) { return at.mustBe("a list of rows, each " + std::string(kIndexRow)); };
  if (!list || list->empty()) return refuse(in);
  for (const toml::node& element : *list) {
    const Value one{element, in.key, in.complaints};
    const auto row = one.numbersIn(2, 3, {});
    if (!row || !isIndexRow(*row, before)) return refuse(one);
    out.hasK = row->size() == 3;
    out.nodes.push_back({row->at(0), row->at(1), out.hasK ? row->at(2) : 0.0});
    before = *row;
  }
  return true;
}

Json IndexRows::schema() const {
  return {{"type", "array"}, {"minItems", 1}, {"items", listSchema({{"type", "number"}, {"minimum", 0}}, 2, 3)}};
}

bool Index::read(const Value& in, IndexSettings& out) const {
  if (const auto material = memberNamedBy<Material>(in)) {
    out = PublishedIndex{*material};
    return true;
  }
  if (const toml::array* list = in.node.as_array(); list && !list->empty()) return readMixture(in, *list, out);
  if (const toml::table* table = in.node.as_table()) return readKeys(in, *table, out);
  const auto index = in.numberIn(kIndexRange);
  if (!index)
    return in.mustBe("one of " + listNames(kNamesOf<Material>) + ", a number " + kIndexRange.text() +
                         ", a list of such, { sellmeier = […] }, { cauchy = […] } or the name of a .csv file",
                     didYouMean(in.string().value_or(""), kNamesOf<Material>));
  out = ConstantIndex{*index};
  return true;
}

bool Absorption::read(const Value& in, IceSettings& out) const {
  const auto flag = in.node.value_exact<bool>();
  const auto k = in.numberIn(kImaginary);
  if (!flag && !k)
    return in.mustBe("true, false or a number " + kImaginary.text() + ", the imaginary part of the index");
  out.absorbs = flag.value_or(true);
  out.k = k;
  return true;
}

Json Absorption::schema() const { return {{"anyOf", {Flag{}.schema(), numberSchema(kImaginary)}}}; }

Json Index::schema() const {
  const Json number = numberSchema(kIndexRange);
  return {{"anyOf",
           {Choice<Material>{}.schema(), number, Json{{"type", "array"}, {"minItems", 1}, {"items", number}},
            tableSchema<IndexKeys>(), Json{{"type", "string"}, {"pattern", "\\.csv$"}}}}};
}

Json Index::write(const IndexSettings& value) const {
  return std::visit(Overloaded{
                        [](const PublishedIndex& own) { return Json(nameOf(own.material)); },
                        [](const ConstantIndex& own) { return Json(own.index); },
                        [](const IndexMixture& own) { return Json(own.indices); },
                        [](const auto&) { return Json(); },
                    },
                    value);
}

}  // namespace parhelion::kinds
