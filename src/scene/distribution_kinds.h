// SPDX-License-Identifier: Apache-2.0
#pragma once

// Kinds (kinds.h) of value that are a number or a distribution of numbers: { normal = [90, 1] }.

#include <optional>
#include <string_view>
#include <variant>

#include "scene/kinds.h"

namespace parhelion {

/// Haze as scene files have it, but for its phase function.
struct HazeWords {
  static constexpr std::string_view kName = "haze";
  std::optional<double> g = std::nullopt;
};

/// The words for what scatters light: the shapes of crystals, and haze.
using PopulationShape =
    std::variant<PrismSettings, PyramidSettings, PlanesSettings, MeshSettings, RosetteSettings, HazeWords>;

/// What words make of the shape of a crystal.
inline PopulationShape wordsOf(const ShapeSettings& shape) {
  return std::visit([](const auto& own) { return PopulationShape(own); }, shape);
}

/// The crystals that words mean; none for haze.
inline std::optional<ShapeSettings> crystalOf(const PopulationShape& words) {
  const auto same = [](const auto& own) -> std::optional<ShapeSettings> {
    if constexpr (requires { ShapeSettings(own); }) return own;
    return std::nullopt;
  };
  return std::visit(same, words);
}

}  // namespace parhelion

namespace parhelion::kinds {

/// An angle with its mean, degrees: a number or a distribution.
struct AngleValue {
  enum class Of { zenith, turn } of;  // a turn is an azimuth or a roll, for which polar-normal is normal

  bool read(const Value& in, AngleDistribution& out) const;
  Json schema() const;
  Json write(const AngleDistribution& value) const;
};

/// The spread of an angle about 0, degrees: the sigma of a normal distribution, or a distribution without its mean.
struct Spread {
  bool read(const Value& in, AngleDistribution& out) const;
  Json schema() const;
  Json write(const AngleDistribution&) const { return {}; }
};

/// A length, a share or an angle of a crystal: a number or a distribution with its mean. In this unit, where it has
/// one; degrees are radians in the settings.
struct Length {
  Range range;
  std::string_view unit = {};

  bool read(const Value& in, LengthDistribution& out) const;
  Json schema() const;
  Json write(const LengthDistribution& value) const;

 private:
  bool isAngle() const { return unit == "degrees"; }
};

/// The aspect ratio: a number or a distribution. It fills the member `aspect` of
/// the chosen shape, if it has one (member_kinds.h).
struct Aspect {
  bool read(const Value& in, PopulationShape& out) const;
  Json schema() const;
  Json write(const PopulationShape& value) const;
  bool isOf(const PopulationShape& chosen) const;
};

}  // namespace parhelion::kinds
