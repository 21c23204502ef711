// SPDX-License-Identifier: Apache-2.0
#pragma once

// Kinds (kinds.h) of value that are a number or a distribution of numbers: { normal = [90, 1] }.

#include <span>
#include <string_view>
#include <utility>

#include "scene/kinds.h"

namespace parhelion {

/// One way to write a distribution.
struct DistributionForm {
  std::string_view name;           // the key in the inline table
  std::string_view first, second;  // what the two numbers are, for messages
  AngleDistribution (*make)(double, double);
};

/// What AngleValue, Spread and Aspect have in common. Numbers are those of the file; `scale` makes settings of them.
struct DistributionSyntax {
  std::span<const DistributionForm> forms;
  std::string_view fixed;  // what a number alone is, for messages
  Range location;          // of a mean, a fixed value and the ends of a range
  Range spread;            // of sigma, amplitude and so on
  double scale = 1.0;      // radians(1) for degrees
  bool aboutZero = false;  // the mean is left out, and a number alone is the first form's spread

  bool read(const Value& in, AngleDistribution& out) const;
  Json schema() const;

 private:
  using Pair = std::pair<double, double>;

  bool readForm(const Value& in, const DistributionForm& form, AngleDistribution& out) const;
  std::optional<Pair> readPair(const Value& in, const DistributionForm& form) const;
  std::optional<Pair> readSpread(const Value& in, const DistributionForm& form) const;
  std::string expected() const;
};

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

/// The aspect ratio: a number, for prisms also a distribution.
struct Aspect {
  ShapeName shape;

  bool read(const Value& in, AspectDistribution& out) const;
  Json schema() const;
  Json write(const AspectDistribution& value) const;
};

}  // namespace parhelion
