// SPDX-License-Identifier: Apache-2.0
#include <cctype>
#include <set>

#include "math/overloaded.h"
#include "scene/scene_keys.h"

namespace parhelion::kinds {

namespace {

using Source = ContinuousSpectrum::Source;

// Where the 1931 observer sees anything; the table of ice reaches further on both sides.
constexpr Range kVisibleNanometres{360.0, 830.0};
constexpr Range kWeightRange{0.0, 1e9, true};

Json listSchema(const Range& range) { return {{"type", "array"}, {"items", numberSchema(range)}, {"minItems", 1}}; }

/// What was likely meant by a string that names no spectrum. Illuminants have short names, which people write in many
/// ways: "illuminant a", "CIE-D65".
std::string likelySpectrum(const std::string& text) {
  if (text.empty()) return "";
  std::string word = text.substr(text.find_last_of(" -_") + 1);
  if (!word.empty()) word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
  for (const std::string_view name : kNamesOf<Source>)
    if (name == word) return "did you mean '" + word + "'?";
  if (text.starts_with("black")) return "a black body is { blackbody = 3000 }, in kelvin";
  return didYouMean(text, kNamesOf<Source>);
}

/// Complains where the keys of a table do not make a spectrum.
bool checkKeys(const Value& in, TableReader& reader, const SpectrumKeys& keys) {
  const bool lines = reader.has("wavelengths"), thermal = reader.has("blackbody");
  if (!lines && !thermal)
    return in.reject("a spectrum's table needs 'wavelengths' or 'blackbody'",
                     "{ wavelengths = [450, 550, 650], weights = [1, 2, 1] } or { blackbody = 3000 }");
  for (const std::string_view key : {"wavelengths", "weights"})
    if (thermal && reader.has(key)) {
      reader.reject(key, "a black body has no '" + std::string(key) + "'", "leave 'blackbody' or this out");
      return false;
    }
  const bool good = !reader.rejected("wavelengths") && !reader.rejected("weights") && !reader.rejected("blackbody");
  if (good && reader.has("weights") && keys.weights.size() != keys.wavelengths.size()) {
    reader.reject("weights", std::to_string(keys.weights.size()) + " 'weights' for " +
                                 std::to_string(keys.wavelengths.size()) + " 'wavelengths'; each needs one");
    return false;
  }
  return good;
}

bool readTable(const Value& in, const toml::table& table, SpectrumSettings& out) {
  TableReader reader(table, "the spectrum", in.complaints);
  SpectrumKeys keys;
  visitKeys(reader, keys);
  if (!reader.rejectUnknown() || !checkKeys(in, reader, keys)) return false;
  if (keys.blackbody)
    out = BlackBody{*keys.blackbody};
  else
    out = LineSpectrum{keys.wavelengths, keys.weights};
  return true;
}

}  // namespace

bool Wavelengths::read(const Value& in, std::vector<double>& out) const {
  const toml::array* list = in.node.as_array();
  if (!list || list->empty()) return in.mustBe("a list of wavelengths " + kVisibleNanometres.text() + " nm");
  std::set<double> seen;
  bool good = true;
  for (const toml::node& element : *list) {
    const Value line{element, in.key, in.complaints};
    const auto wavelength = line.numberIn(kVisibleNanometres);
    if (!wavelength) {
      good = line.mustBe("a list of wavelengths " + kVisibleNanometres.text() + " nm here");
    } else if (!seen.insert(*wavelength).second) {
      good = line.reject("the wavelength " + formatNumber(*wavelength) + " nm is listed twice");
    } else {
      out.push_back(*wavelength);
    }
  }
  return good;
}

Json Wavelengths::schema() const {
  Json list = listSchema(kVisibleNanometres);
  list["uniqueItems"] = true;
  return list;
}

bool Weights::read(const Value& in, std::vector<double>& out) const {
  const toml::array* list = in.node.as_array();
  if (!list || list->empty()) return in.mustBe("a list of numbers " + kWeightRange.text());
  bool good = true;
  for (const toml::node& element : *list) {
    const Value one{element, in.key, in.complaints};
    const auto weight = one.numberIn(kWeightRange);
    if (weight)
      out.push_back(*weight);
    else
      good = one.mustBe("a list of numbers " + kWeightRange.text() + " here");
  }
  return good;
}

Json Weights::schema() const { return listSchema(kWeightRange); }

bool Spectrum::read(const Value& in, SpectrumSettings& out) const {
  if (const auto source = memberNamedBy<Source>(in)) {
    out = ContinuousSpectrum{*source};
    return true;
  }
  if (const auto wavelength = in.numberIn(kVisibleNanometres)) {
    out = MonochromaticSpectrum{*wavelength};
    return true;
  }
  if (const toml::array* list = in.node.as_array(); list && !list->empty()) {
    LineSpectrum lines;
    if (!Wavelengths{}.read(in, lines.wavelengths)) return false;
    out = std::move(lines);
    return true;
  }
  if (const toml::table* table = in.node.as_table()) return readTable(in, *table, out);
  return in.mustBe("one of " + listNames(kNamesOf<Source>) + ", a wavelength " + kVisibleNanometres.text() +
                       " nm, a list of wavelengths, { wavelengths = […], weights = […] } or { blackbody = kelvin }",
                   likelySpectrum(in.string().value_or("")));
}

Json Spectrum::schema() const {
  return {{"anyOf",
           {Choice<Source>{}.schema(), numberSchema(kVisibleNanometres), Wavelengths{}.schema(),
            tableSchema<SpectrumKeys>()}}};
}

Json Spectrum::write(const SpectrumSettings& value) const {
  return std::visit(Overloaded{
                        [](const ContinuousSpectrum& s) { return Json(nameOf(s.source)); },
                        [](const MonochromaticSpectrum& s) { return Json(s.wavelength); },
                        [](const LineSpectrum& s) {
                          if (s.weights.empty()) return Json(s.wavelengths);
                          return Json{{"wavelengths", s.wavelengths}, {"weights", s.weights}};
                        },
                        [](const BlackBody& s) {
                          return Json{{"blackbody", s.temperature}};
                        },
                    },
                    value);
}

}  // namespace parhelion::kinds
