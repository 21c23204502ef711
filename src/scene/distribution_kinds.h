// SPDX-License-Identifier: Apache-2.0
#pragma once

// Kinds (kinds.h) of value that are a number or a distribution of numbers: { normal = [90, 1] }.

#include "scene/kinds.h"

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

/// The aspect ratio: a number, for shapes that can be stretched also a distribution. It fills the member `aspect` of
/// the chosen shape, if it has one (member_kinds.h).
struct Aspect {
  bool read(const Value& in, ShapeSettings& out) const;
  Json schema() const;
  Json write(const ShapeSettings& value) const;
  bool isOf(const ShapeSettings& chosen) const;
};

}  // namespace parhelion::kinds
