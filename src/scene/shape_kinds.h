// SPDX-License-Identifier: Apache-2.0
#pragma once

// Kinds (kinds.h) of key that describe the faces of crystals. They fill a chosen shape (member_kinds.h). What differs
// from crystal to crystal goes to the shape's spreads.

#include <array>
#include <optional>
#include <vector>

#include "scene/distribution_kinds.h"
#include "scene/schema_writer.h"

namespace parhelion {

/// An end of a pyramid as a table.
struct PyramidEndKeys {
  LengthDistribution height = FixedValue{PyramidSettings{}.upper};
  std::optional<LengthDistribution> slope = std::nullopt;   // rad
  std::optional<std::array<int, 2>> miller = std::nullopt;  // h and l of {h 0 -h l}
};

/// A plane of a crystal as a table.
struct PlaneKeys {
  std::optional<Vec3> normal = std::nullopt;
  double distance = 1.0;
  std::optional<int> face = std::nullopt;
};

/// Sides that are drawn together as a table, one key at a time.
struct TiedSideKeys {
  std::optional<LengthDistribution> twofold = std::nullopt, threefold = std::nullopt, sixfold = std::nullopt;
};

namespace kinds {

/// Distances of the six prism faces from the axis.
struct SideDistances {
  bool read(const Value& in, PopulationShape& out) const;
  Json schema() const;
  Json write(const PopulationShape&) const { return kRegularSides; }
  bool isOf(const PopulationShape& chosen) const {
    return std::holds_alternative<PrismSettings>(chosen) || std::holds_alternative<PyramidSettings>(chosen);
  }
};

/// [h, 0, -h, l].
struct Miller {
  bool read(const Value& in, std::array<int, 2>& out) const;
  Json schema() const;
  Json write(const std::array<int, 2>&) const { return {}; }
};

/// One end of a pyramid: its height, or a table that also says how steep it is.
struct PyramidEnd {
  bool isUpper;

  bool read(const Value& in, PopulationShape& out) const;
  Json schema() const;
  Json write(const PopulationShape&) const { return PyramidSettings{}.upper; }
  bool isOf(const PopulationShape& chosen) const { return std::holds_alternative<PyramidSettings>(chosen); }
};

/// How steep both ends of a pyramid are, degrees.
struct PyramidSlope {
  bool read(const Value& in, PopulationShape& out) const;
  Json schema() const;
  Json write(const PopulationShape&) const { return roundToTwelveDigits(degrees(PyramidSettings{}.slope)); }
  bool isOf(const PopulationShape& chosen) const { return std::holds_alternative<PyramidSettings>(chosen); }
};

/// A pit in one end of a prism or in both: a table.
struct CavityTable {
  bool upper, lower;

  bool read(const Value& in, PopulationShape& out) const;
  Json schema() const { return tableSchema<Cavity>(); }
  Json write(const PopulationShape&) const { return {}; }
  bool isOf(const PopulationShape& chosen) const { return std::holds_alternative<PrismSettings>(chosen); }
};

/// An OBJ in full: a string of more than one line (mesh_files.h puts it in the place of a file's name).
struct Mesh {
  bool read(const Value& in, PopulationShape& out) const;
  Json schema() const { return {{"type", "string"}, {"minLength", 1}}; }
  Json write(const PopulationShape&) const { return {}; }
  bool isOf(const PopulationShape& chosen) const { return std::holds_alternative<MeshSettings>(chosen); }
};

/// A direction [x, y, z] of any length.
struct Direction {
  bool read(const Value& in, Vec3& out) const;
  Json schema() const;
  Json write(const Vec3&) const { return {}; }
};

/// A list of planes, each a table. They are not yet known to close.
struct PlaneList {
  bool read(const Value& in, std::vector<FacePlane>& out) const;
  Json schema() const;
  Json write(const std::vector<FacePlane>&) const { return {}; }
};

}  // namespace kinds

}  // namespace parhelion
