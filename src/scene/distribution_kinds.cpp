// SPDX-License-Identifier: Apache-2.0
#include "scene/distribution_kinds.h"

#include <vector>

#include "math/overloaded.h"

namespace parhelion::kinds {

namespace {

/// One way to write a distribution: the key in the inline table is its name.
template <class Variant>
struct Form {
  DistributionWords words;
  Variant (*make)(double, double);
};

/// The forms of all alternatives but the fixed value, which is a number alone.
template <class Variant>
struct Forms;

template <class... Ds>
struct Forms<std::variant<FixedValue, Ds...>> {
  using Variant = std::variant<FixedValue, Ds...>;
  static constexpr Form<Variant> kAll[] = {{Ds::kWords, [](double first, double second) -> Variant {
                                              return Ds{first, second};
                                            }}...};
};

/// What AngleValue, Spread and Aspect have in common. Numbers are those of the file; `scale` makes settings of them.
template <class Variant>
struct Syntax {
  std::string_view fixed;  // what a number alone is, for messages
  Range location;          // of a mean and a fixed value
  Range end;               // of a range
  Range spread;            // of sigma, amplitude and so on
  double scale = 1.0;      // radians(1) for degrees
  bool aboutZero = false;  // the mean is left out, and a number alone is the first form's spread

  bool read(const Value& in, Variant& out) const;
  Json schema() const;

 private:
  using OneForm = Form<Variant>;
  using Pair = std::pair<double, double>;
  static constexpr std::span<const OneForm> kForms = Forms<Variant>::kAll;

  bool readForm(const Value& in, const OneForm& form, Variant& out) const;
  std::optional<Pair> readPair(const Value& in, const DistributionWords& words) const;
  std::optional<Pair> readSpread(const Value& in, const DistributionWords& words) const;
  std::string expected() const;
};

constexpr Range kSpreadDegrees{0.0, 180.0};
constexpr Range kAspectRange{kThinnestAspect, kLongestAspect};
constexpr Range kFixedAspectRange{0.0, kLongestAspect};  // of shapes that are more than a prism

Syntax<AngleDistribution> syntaxOf(AngleValue::Of of) {
  constexpr Range kTurns{-360.0, 360.0};
  if (of == AngleValue::Of::turn) return {"degrees", kTurns, kTurns, kSpreadDegrees, radians(1.0)};
  // A range may begin or end beyond a pole.
  return {"degrees", {0.0, 180.0}, {-180.0, 360.0}, kSpreadDegrees, radians(1.0)};
}

Syntax<AngleDistribution> spreadSyntax() { return {"degrees", {}, {}, kSpreadDegrees, radians(1.0), true}; }

std::string pairOf(const DistributionWords& words) {
  return std::string("[").append(words.first) + ", " + std::string(words.second) + "]";
}

template <class Variant>
std::string Syntax<Variant>::expected() const {
  std::string text = "a number " + (aboutZero ? spread : location).text() + " (" + std::string(fixed) + ") or one of";
  for (const OneForm& form : kForms) {
    const std::string parameters = aboutZero ? "spread" : pairOf(form.words);
    text += std::string(" { ").append(form.words.name) + " = " + parameters + " }";
  }
  return text;
}

template <class Variant>
bool Syntax<Variant>::read(const Value& in, Variant& out) const {
  if (in.isNumber() && aboutZero) return readForm(in, kForms.front(), out);
  if (const auto number = in.numberIn(location); number && !aboutZero) {
    out = FixedValue{*number * scale};
    return true;
  }
  const toml::table* table = in.node.as_table();
  if (!table || table->size() != 1) return in.mustBe(expected());

  const auto entry = table->begin();
  const toml::key& key = entry->first;
  std::vector<std::string_view> names;
  for (const OneForm& form : kForms) {
    if (form.words.name == key.str()) return readForm({entry->second, form.words.name, in.complaints}, form, out);
    names.push_back(form.words.name);
  }
  in.complaints.add(placeOf(key.source(), in.complaints),
                    std::string("unknown distribution; '").append(in.key) + "' must be " + expected(),
                    didYouMean(key.str(), names));
  return false;
}

template <class Variant>
auto Syntax<Variant>::readPair(const Value& in, const DistributionWords& words) const -> std::optional<Pair> {
  const toml::array* list = in.node.as_array();
  if (!list || list->size() != 2) {
    in.mustBe(pairOf(words));
    return std::nullopt;
  }
  const Number first{words.isRange ? end : location}, second{words.isRange ? end : spread};
  Pair pair;
  const bool firstGood = first.read({(*list)[0], words.first, in.complaints}, pair.first);
  const bool secondGood = second.read({(*list)[1], words.second, in.complaints}, pair.second);
  if (!firstGood || !secondGood) return std::nullopt;
  if (words.isRange && pair.first > pair.second) {
    in.reject("the range ends before it begins");
    return std::nullopt;
  }
  return pair;
}

template <class Variant>
auto Syntax<Variant>::readSpread(const Value& in, const DistributionWords& words) const -> std::optional<Pair> {
  double width = 0.0;
  if (!Number{spread}.read(in, width)) return std::nullopt;
  return words.isRange ? Pair{-width, width} : Pair{0.0, width};
}

template <class Variant>
bool Syntax<Variant>::readForm(const Value& in, const OneForm& form, Variant& out) const {
  const std::optional<Pair> pair = aboutZero ? readSpread(in, form.words) : readPair(in, form.words);
  if (!pair) return false;
  // A spread of nothing is a fixed value, so that no sampler ever divides by 0.
  const bool isFixed = form.words.isRange ? pair->first == pair->second : pair->second == 0.0;
  const double first = pair->first * scale;
  out = isFixed ? FixedValue{first} : form.make(first, pair->second * scale);
  return true;
}

template <class Variant>
Json Syntax<Variant>::schema() const {
  const Json pair = {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 2}, {"maxItems", 2}};
  Json table = {{"type", "object"}, {"additionalProperties", false}, {"minProperties", 1}, {"maxProperties", 1}};
  for (const OneForm& form : kForms) {
    Json& entry = table["properties"][std::string(form.words.name)];
    entry = aboutZero ? numberSchema(spread) : pair;
    if (!aboutZero) entry["description"] = pairOf(form.words);
  }
  return {{"anyOf", {numberSchema(aboutZero ? spread : location), table}}};
}

/// A distribution as scene files write it, its numbers by `number`.
template <class Variant>
Json written(const Variant& distribution, double (*number)(double)) {
  const auto fixed = [=](const FixedValue& d) { return Json(number(d.value)); };
  const auto spread = [=]<class D>(const D& d) -> Json {
    const auto& [first, second] = d;
    Json table;
    table[std::string(D::kWords.name)] = {number(first), number(second)};
    return table;
  };
  return std::visit(Overloaded{fixed, spread}, distribution);
}

bool readAspect(const Value& in, PrismSettings& prism) {
  LengthDistribution aspect;
  if (!Length{kAspectRange}.read(in, aspect)) return false;
  // Crystals are stretched along c where they can be, and cut out anew where not.
  std::visit(Overloaded{[&](const Laplace& d) {
                          prism.spreads.push_back({ShapeLength::aspect, {}, d});
                        },
                        [&](const LogNormal& d) {
                          prism.spreads.push_back({ShapeLength::aspect, {}, d});
                        },
                        [&](const auto& d) { prism.aspect = d; }},
             aspect);
  return true;
}

bool readAspect(const Value& in, PyramidSettings& pyramid) {
  LengthDistribution aspect;
  if (!Length{kFixedAspectRange}.read(in, aspect)) return false;
  setLength(pyramid, {ShapeLength::aspect, {}, aspect});
  return true;
}

bool readAspect(const Value& in, RosetteSettings& rosette) { return Number{kAspectRange}.read(in, rosette.aspect); }

Json writtenAspect(const AspectDistribution& aspect) {
  return written(aspect, [](double value) { return value; });
}
Json writtenAspect(double aspect) { return aspect; }

}  // namespace

bool AngleValue::read(const Value& in, AngleDistribution& out) const {
  if (!syntaxOf(of).read(in, out)) return false;
  if (of == Of::turn) out = asTurn(out);
  return true;
}

Json AngleValue::schema() const { return syntaxOf(of).schema(); }

Json AngleValue::write(const AngleDistribution& value) const {
  return written(value, [](double angle) { return roundToTwelveDigits(degrees(angle)); });
}

bool Spread::read(const Value& in, AngleDistribution& out) const { return spreadSyntax().read(in, out); }

Json Spread::schema() const { return spreadSyntax().schema(); }

bool Length::read(const Value& in, LengthDistribution& out) const {
  const Syntax<LengthDistribution> syntax{
      isAngle() ? "degrees" : "the same for all crystals", range, range, {0.0, 1e4}, isAngle() ? radians(1.0) : 1.0};
  if (in.isNumber() && !in.numberIn(range)) return in.mustBe(numberText(range, unit));
  if (!syntax.read(in, out)) return false;
  if (auto* lognormal = std::get_if<LogNormal>(&out)) {
    if (isAngle()) lognormal->sigma /= radians(1.0);  // it is of the logarithm, which has no unit
    if (!(lognormal->median > 0.0)) return in.reject("the median of a lognormal distribution must be above 0");
  }
  return true;
}

Json Length::schema() const { return Syntax<LengthDistribution>{"", range, range, {0.0, 1e4}}.schema(); }

Json Length::write(const LengthDistribution& value) const {
  if (isAngle()) return written(value, [](double angle) { return roundToTwelveDigits(degrees(angle)); });
  return written(value, [](double x) { return x; });
}

bool Aspect::read(const Value& in, PopulationShape& out) const {
  return std::visit(
      [&](auto& shape) {
        if constexpr (requires { shape.aspect; }) return readAspect(in, shape);
        return true;
      },
      out);
}

Json Aspect::schema() const { return Length{kFixedAspectRange}.schema(); }

Json Aspect::write(const PopulationShape& value) const {
  return std::visit(
      [](const auto& shape) {
        if constexpr (requires { shape.aspect; }) return writtenAspect(shape.aspect);
        return Json();
      },
      value);
}

bool Aspect::isOf(const PopulationShape& chosen) const {
  return std::visit(
      [](const auto& shape) {
        return requires { shape.aspect; };
      },
      chosen);
}

}  // namespace parhelion::kinds
