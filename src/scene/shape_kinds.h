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

/// The schema of a table that must have a key.
inline Json tableWith(Json table, std::string_view needed) {
  table["required"] = {needed};
  return table;
}

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

/// How steep both ends of a pyramid are, or the bullets of a rosette, degrees.
struct PyramidSlope {
  bool read(const Value& in, PopulationShape& out) const;
  Json schema() const;
  Json write(const PopulationShape&) const { return roundToTwelveDigits(degrees(PyramidSettings{}.slope)); }
  bool isOf(const PopulationShape& chosen) const {
    return std::holds_alternative<PyramidSettings>(chosen) || std::holds_alternative<RosetteSettings>(chosen);
  }
};

/// Something about one end of a prism or both, `Part` of PrismEnd: a table that must have the key `needed`.
template <class Part>
struct PrismEndTable {
  Part PrismEnd::*part;
  bool upper, lower;
  std::string_view needed, hint;

  bool read(const Value& in, PopulationShape& out) const;
  Json schema() const { return tableWith(tableSchema<Part>(), needed); }
  Json write(const PopulationShape&) const { return {}; }
  bool isOf(const PopulationShape& chosen) const { return std::holds_alternative<PrismSettings>(chosen); }
};

/// A pit, a cap.
inline PrismEndTable<Cavity> cavityTable(bool upper, bool lower) {
  return {&PrismEnd::cavity, upper, lower, "depth", "a pit in the end of a prism: { depth = 0.4, width = 0.8 }"};
}
inline PrismEndTable<Cap> capTable(bool upper, bool lower) {
  return {&PrismEnd::cap, upper, lower, "width", "a plate on the end of a prism: { width = 3, aspect = 0.1 }"};
}

/// Notches in the sides of a prism: a table.
struct NotchTable {
  bool read(const Value& in, PopulationShape& out) const;
  Json schema() const { return tableWith(tableSchema<Notch>(), "depth"); }
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
