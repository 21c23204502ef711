// SPDX-License-Identifier: Apache-2.0
#pragma once

// The kinds of value a key can have. A kind says once what it accepts:
//
//   bool read(const Value&, T& out) const   fills `out`, or complains and returns false
//   Json schema() const                     what it accepts, as JSON Schema
//   Json write(const T&) const              a value as scene files write it, null for none; for the schema's defaults

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "math/date_time.h"
#include "math/names.h"
#include "scene/number_schema.h"
#include "scene/scene.h"
#include "scene/suggest.h"
#include "scene/value.h"

namespace parhelion::kinds {

struct Flag {
  bool read(const Value& in, bool& out) const;
  Json schema() const { return {{"type", "boolean"}}; }
  Json write(bool value) const { return value; }
};

/// A short string for people: a name.
struct Text {
  static constexpr std::size_t kMaxLength = 100;  // code points

  bool read(const Value& in, std::string& out) const;
  Json schema() const { return {{"type", "string"}, {"minLength", 1}, {"maxLength", kMaxLength}}; }
  Json write(const std::string& value) const { return value; }
};

/// "a number from 0 to 90 degrees".
std::string numberText(const Range& range, std::string_view unit);

/// A number, in this unit where it has one: the settings have the same.
struct Number {
  Range range;
  std::string_view unit = {};

  bool read(const Value& in, double& out) const;
  Json schema() const { return numberSchema(range); }
  Json write(double value) const { return value; }
};

/// An integer.
struct WholeNumber {
  int least, most;

  bool read(const Value& in, int& out) const;
  Json schema() const { return {{"type", "integer"}, {"minimum", least}, {"maximum", most}}; }
  Json write(int value) const { return value; }
};

/// Degrees in the file, radians in the settings.
struct Angle {
  Range degreesRange;

  bool read(const Value& in, double& out) const;
  Json schema() const { return numberSchema(degreesRange); }
  Json write(double value) const { return roundToTwelveDigits(degrees(value)); }
};

/// An integer from 0.
struct Seed {
  bool read(const Value& in, std::uint64_t& out) const;
  Json schema() const { return {{"type", "integer"}, {"minimum", 0}}; }
  Json write(std::uint64_t value) const { return value; }
};

/// A date and time with an offset from UTC, of TOML's own kind.
struct Date {
  bool read(const Value& in, DateTime& out) const;
  Json schema() const { return {{"type", "string"}, {"format", "date-time"}}; }
  Json write(const DateTime& value) const { return textOf(value); }
};

/// A number or a string for parseRayCount().
struct RayCount {
  bool read(const Value& in, std::uint64_t& out) const;
  Json schema() const;
  Json write(std::uint64_t value) const { return value; }
};

/// [width, height] in pixels.
struct Resolution {
  bool read(const Value& in, std::array<int, 2>& out) const;
  Json schema() const;
  Json write(const std::array<int, 2>& value) const { return value; }
};

/// A list of different wavelengths, nm.
struct Wavelengths {
  bool read(const Value& in, std::vector<double>& out) const;
  Json schema() const;
  Json write(const std::vector<double>&) const { return {}; }
};

/// A list of numbers above 0.
struct Weights {
  bool read(const Value& in, std::vector<double>& out) const;
  Json schema() const;
  Json write(const std::vector<double>&) const { return {}; }
};

/// The name of a continuous spectrum, a wavelength, a list of wavelengths, or a table with the keys of SpectrumKeys
/// (scene_keys.h).
struct Spectrum {
  bool read(const Value& in, SpectrumSettings& out) const;
  Json schema() const;
  Json write(const SpectrumSettings& value) const;
};

/// A pattern of raypaths, or the name of a halo.
struct Paths {
  bool read(const Value& in, PathPattern& out) const;
  Json schema() const { return {{"type", {"string", "integer"}}, {"minLength", 1}, {"minimum", 1}}; }
  Json write(const PathPattern& value) const { return value.text; }
};

/// A list of different names.
struct Names {
  bool read(const Value& in, std::vector<std::string>& out) const;
  Json schema() const;
  Json write(const std::vector<std::string>&) const { return {}; }
};

/// The names in quotation marks, with commas.
std::string listNames(std::span<const std::string_view> names);

/// The member of a family (math/names.h) that a value names, if it is a name of one.
template <class Family>
std::optional<Family> memberNamedBy(const Value& in) {
  const auto name = in.string();
  return name ? memberNamed<Family>(*name) : std::nullopt;
}

/// One of the names of a family: an enumerator, or an alternative with the defaults of its settings.
template <class Family>
struct Choice {
  bool read(const Value& in, Family& out) const {
    if (auto chosen = memberNamedBy<Family>(in)) {
      out = *std::move(chosen);
      return true;
    }
    const auto& names = kNamesOf<Family>;
    return in.mustBe(std::string("one of ").append(listNames(names)), didYouMean(in.string().value_or(""), names));
  }
  Json schema() const { return {{"enum", kNamesOf<Family>}}; }
  Json write(const Family& value) const { return nameOf(value); }
};

/// A value that may be left out without a default of its own.
template <class Kind>
struct Optional {
  Kind kind;

  template <class T>
  bool read(const Value& in, std::optional<T>& out) const {
    T value{};
    if (!kind.read(in, value)) return false;
    out = value;
    return true;
  }
  Json schema() const { return kind.schema(); }
  template <class T>
  Json write(const std::optional<T>& value) const {
    return value ? kind.write(*value) : Json();
  }
};

template <class Kind>
Optional(Kind) -> Optional<Kind>;

}  // namespace parhelion::kinds
