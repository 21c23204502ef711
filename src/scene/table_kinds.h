// SPDX-License-Identifier: Apache-2.0
#pragma once

// Kinds (kinds.h) whose values are tables with keys of their own.

#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "scene/schema_writer.h"
#include "scene/table_reader.h"

namespace parhelion {

/// The words for orientations that need no more than a tilt and a roll.
enum class OrientationName { random, plate, column, parry, lowitz };

constexpr std::string_view nameOf(OrientationName value) {
  switch (value) {
    case OrientationName::random:
      return "random";
    case OrientationName::plate:
      return "plate";
    case OrientationName::column:
      return "column";
    case OrientationName::parry:
      return "parry";
    case OrientationName::lowitz:
      return "lowitz";
  }
  return {};
}

/// Kinds of ground that have names.
enum class GroundName { snow, grass, sea };

constexpr std::string_view nameOf(GroundName value) {
  switch (value) {
    case GroundName::snow:
      return "snow";
    case GroundName::grass:
      return "grass";
    case GroundName::sea:
      return "sea";
  }
  return {};
}

/// The defaults of a camera with this projection.
CameraSettings defaultCamera(Projection projection);

/// An orientation as scene files have it.
using OrientationWords = std::variant<OrientationName, AxisOrientation>;

namespace kinds {

/// A table whose keys fill the members of T one by one, by visitKeys(visitor, T&).
template <class T>
struct Table {
  std::string_view title;

  bool read(const Value& in, T& out) const {
    const toml::table* table = in.node.as_table();
    if (!table) return in.mustBe("a table");
    TableReader reader(*table, title, in.complaints);
    visitKeys(reader, out);
    reader.rejectUnknown();
    return true;
  }
  Json schema() const { return tableSchema<T>(); }
  Json write(const T&) const { return {}; }
};

/// [sun]; where it stands is said by an elevation, or by a date and a place.
struct SunTable {
  bool read(const Value& in, SunSettings& out) const;
  Json schema() const;
  Json write(const SunSettings&) const { return {}; }
};

/// [camera]; fields of view are held against the projection.
struct CameraTable {
  bool read(const Value& in, CameraSettings& out) const;
  Json schema() const;
  Json write(const CameraSettings&) const { return {}; }
};

/// [recon]; keys of other methods than the chosen one are refused.
struct Recon {
  bool read(const Value& in, ReconSettings& out) const;
  Json schema() const;
  Json write(const ReconSettings&) const { return {}; }
};

/// How often light may be scattered: a whole number, or "all".
struct Orders {
  bool read(const Value& in, int& out) const;
  Json schema() const;
  Json write(int orders) const { return orders; }
};

/// The refractive index: a material's name, numbers, or a table with the keys of IndexKeys (scene_keys.h).
struct Index {
  bool read(const Value& in, IndexSettings& out) const;
  Json schema() const;
  Json write(const IndexSettings& value) const;
};

/// Whether and by how much crystals absorb.
struct Absorption {
  bool read(const Value& in, IceSettings& out) const;
  Json schema() const;
  Json write(const IceSettings& value) const { return value.absorbs; }
};

/// Sellmeier's terms, a list of [strength, resonance].
struct SellmeierTerms {
  bool read(const Value& in, std::vector<SellmeierIndex::Term>& out) const;
  Json schema() const;
  Json write(const std::vector<SellmeierIndex::Term>&) const { return {}; }
};

/// Cauchy's coefficients.
struct CauchyCoefficients {
  bool read(const Value& in, std::vector<double>& out) const;
  Json schema() const;
  Json write(const std::vector<double>&) const { return {}; }
};

/// Measured indices, a list of [wavelength, n] or of [wavelength, n, k].
struct IndexRows {
  bool read(const Value& in, IndexTable& out) const;
  Json schema() const;
  Json write(const IndexTable&) const { return {}; }
};

/// A phase function as a list of pairs.
struct Phase {
  bool read(const Value& in, PhaseTable& out) const;
  Json schema() const;
  Json write(const PhaseTable&) const { return {}; }
};

/// The list of [[cloud.layer]] tables.
struct SlabLayers {
  bool read(const Value& in, std::vector<SlabLayer>& out) const;
  Json schema() const;
  Json write(const std::vector<SlabLayer>&) const { return {}; }
};

/// [cloud], whose depth must be said, or that of each of its layers.
struct Slab {
  bool read(const Value& in, std::optional<SlabSettings>& out) const;
  Json schema() const;
  Json write(const std::optional<SlabSettings>&) const { return {}; }
};

/// The aerosol of the air: its beta, or a table.
struct Aerosol {
  bool read(const Value& in, AerosolSettings& out) const;
  Json schema() const;
  Json write(const AerosolSettings&) const { return {}; }
};

/// The albedo of the aerosol.
struct AerosolAlbedo {
  bool read(const Value& in, double& out) const;
  Json schema() const;
  Json write(double value) const { return value; }
};

/// The albedo of the ground: its name, or a table.
struct Ground {
  bool read(const Value& in, double& out) const;
  Json schema() const;
  Json write(double) const { return {}; }
};

/// The list of [[population]] tables, which are crystals and haze.
struct Populations {
  bool read(const Value& in, Scene& out) const;
  Json schema() const;
  Json write(const Scene&) const { return {}; }
};

/// [from, to], degrees.
struct Tilts {
  bool read(const Value& in, LayerSettings::TiltRange& out) const;
  Json schema() const;
  Json write(const LayerSettings::TiltRange&) const { return {}; }
};

/// The list of [[layer]] tables.
struct Layers {
  bool read(const Value& in, std::vector<LayerSettings>& out) const;
  Json schema() const;
  Json write(const std::vector<LayerSettings>&) const { return {}; }
};

/// A name, or the inline table in full.
struct Orientation {
  bool read(const Value& in, OrientationWords& out) const;
  Json schema() const;
  Json write(const OrientationWords& value) const;
};

}  // namespace kinds

}  // namespace parhelion
