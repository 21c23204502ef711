// SPDX-License-Identifier: Apache-2.0
#include "scene/distribution_kinds.h"

namespace parhelion {

namespace {

constexpr DistributionForm kForms[] = {
    {"normal", "mean", "sigma",
     [](double a, double b) -> AngleDistribution {
       return Normal{a, b};
     }},
    {"uniform", "from", "to",
     [](double a, double b) -> AngleDistribution {
       return UniformRange{a, b};
     }},
    {"polar-normal", "mean", "sigma",
     [](double a, double b) -> AngleDistribution {
       return PolarNormal{a, b};
     }},
    {"arcsine", "mean", "amplitude",
     [](double a, double b) -> AngleDistribution {
       return Arcsine{a, b};
     }},
    {"laplace", "mean", "scale",
     [](double a, double b) -> AngleDistribution {
       return Laplace{a, b};
     }},
};
constexpr std::span<const DistributionForm> kAllForms = kForms;
constexpr std::span<const DistributionForm> kAspectForms = kAllForms.first(2);  // normal and uniform

constexpr Range kSpreadDegrees{0.0, 180.0};
constexpr Range kAspectRange{1e-4, 1e4};
constexpr Range kPyramidAspectRange{0.0, 1e4};

DistributionSyntax syntaxOf(AngleValue::Of of) {
  const Range location = of == AngleValue::Of::zenith ? Range{0.0, 180.0} : Range{-360.0, 360.0};
  return {kAllForms, "degrees", location, kSpreadDegrees, radians(1.0)};
}

DistributionSyntax spreadSyntax() { return {kAllForms, "degrees", {}, kSpreadDegrees, radians(1.0), true}; }

DistributionSyntax aspectSyntax() { return {kAspectForms, "length / width", kAspectRange, {0.0, 1e4}}; }

bool isUniform(const DistributionForm& form) { return form.name == "uniform"; }

std::string pairOf(const DistributionForm& form) {
  return std::string("[").append(form.first) + ", " + std::string(form.second) + "]";
}

}  // namespace

std::string DistributionSyntax::expected() const {
  std::string text = "a number " + (aboutZero ? spread : location).text() + " (" + std::string(fixed) + ") or one of";
  for (const DistributionForm& form : forms) {
    const std::string parameters = aboutZero ? "spread" : pairOf(form);
    text += std::string(" { ").append(form.name) + " = " + parameters + " }";
  }
  return text;
}

bool DistributionSyntax::read(const Value& in, AngleDistribution& out) const {
  if (in.isNumber() && aboutZero) return readForm(in, forms.front(), out);
  if (const auto number = in.numberIn(location); number && !aboutZero) {
    out = FixedValue{*number * scale};
    return true;
  }
  const toml::table* table = in.node.as_table();
  if (!table || table->size() != 1) return in.mustBe(expected());

  const auto entry = table->begin();
  const toml::key& key = entry->first;
  std::vector<std::string_view> names;
  for (const DistributionForm& form : forms) {
    if (form.name == key.str()) return readForm({entry->second, form.name, in.complaints}, form, out);
    names.push_back(form.name);
  }
  in.complaints.add(placeOf(key.source(), in.complaints),
                    std::string("unknown distribution; '").append(in.key) + "' must be " + expected(),
                    didYouMean(key.str(), names));
  return false;
}

std::optional<DistributionSyntax::Pair> DistributionSyntax::readPair(const Value& in,
                                                                     const DistributionForm& form) const {
  const toml::array* list = in.node.as_array();
  if (!list || list->size() != 2) {
    in.mustBe(pairOf(form));
    return std::nullopt;
  }
  Number first{location}, second{isUniform(form) ? location : spread};
  Pair pair;
  const bool firstGood = first.read({(*list)[0], form.first, in.complaints}, pair.first);
  const bool secondGood = second.read({(*list)[1], form.second, in.complaints}, pair.second);
  if (!firstGood || !secondGood) return std::nullopt;
  if (isUniform(form) && pair.first > pair.second) {
    in.reject("the range ends before it begins");
    return std::nullopt;
  }
  return pair;
}

std::optional<DistributionSyntax::Pair> DistributionSyntax::readSpread(const Value& in,
                                                                       const DistributionForm& form) const {
  double width = 0.0;
  if (!Number{spread}.read(in, width)) return std::nullopt;
  return isUniform(form) ? Pair{-width, width} : Pair{0.0, width};
}

bool DistributionSyntax::readForm(const Value& in, const DistributionForm& form, AngleDistribution& out) const {
  const std::optional<Pair> pair = aboutZero ? readSpread(in, form) : readPair(in, form);
  if (!pair) return false;
  // A spread of nothing is a fixed value, so that no sampler ever divides by 0.
  const bool isFixed = isUniform(form) ? pair->first == pair->second : pair->second == 0.0;
  const double first = pair->first * scale;
  out = isFixed ? FixedValue{first} : form.make(first, pair->second * scale);
  return true;
}

Json DistributionSyntax::schema() const {
  const Json pair = {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 2}, {"maxItems", 2}};
  Json table = {{"type", "object"}, {"additionalProperties", false}, {"minProperties", 1}, {"maxProperties", 1}};
  for (const DistributionForm& form : forms) {
    Json& entry = table["properties"][std::string(form.name)];
    entry = aboutZero ? numberSchema(spread) : pair;
    if (!aboutZero) entry["description"] = pairOf(form);
  }
  return {{"anyOf", {numberSchema(aboutZero ? spread : location), table}}};
}

bool AngleValue::read(const Value& in, AngleDistribution& out) const {
  if (!syntaxOf(of).read(in, out)) return false;
  const auto* polar = std::get_if<PolarNormal>(&out);
  if (of == Of::turn && polar) out = Normal{polar->mean, polar->sigma};
  return true;
}

Json AngleValue::schema() const { return syntaxOf(of).schema(); }

Json AngleValue::write(const AngleDistribution& value) const {
  if (const auto* fixed = std::get_if<FixedValue>(&value)) return roundToTwelveDigits(degrees(fixed->value));
  const auto* range = std::get_if<UniformRange>(&value);
  if (!range) return {};
  return {{"uniform", {roundToTwelveDigits(degrees(range->from)), roundToTwelveDigits(degrees(range->to))}}};
}

bool Spread::read(const Value& in, AngleDistribution& out) const { return spreadSyntax().read(in, out); }

Json Spread::schema() const { return spreadSyntax().schema(); }

bool Aspect::read(const Value& in, AspectDistribution& out) const {
  if (shape == ShapeName::pyramid) {
    const auto number = in.numberIn(kPyramidAspectRange);
    if (!number) return in.mustBe(std::string("a number ").append(kPyramidAspectRange.text()) + " for a pyramid");
    out = FixedValue{*number};
    return true;
  }
  AngleDistribution read;
  if (!aspectSyntax().read(in, read)) return false;
  if (const auto* fixed = std::get_if<FixedValue>(&read)) out = *fixed;
  if (const auto* range = std::get_if<UniformRange>(&read)) out = *range;
  if (const auto* normal = std::get_if<Normal>(&read)) out = *normal;
  return true;
}

Json Aspect::schema() const {
  Json schema = aspectSyntax().schema();
  schema["anyOf"][0] = numberSchema(kPyramidAspectRange);
  return schema;
}

Json Aspect::write(const AspectDistribution& value) const { return std::get<FixedValue>(value).value; }

}  // namespace parhelion
