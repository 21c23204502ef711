// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_keys.h"

namespace parhelion::kinds {

namespace {

constexpr Range kShare{0.0, 1.0};
constexpr Range kBeta{0.0, 10.0};

/// Of visible light, whole: Warren 1982, Rev. Geophys. 20, 67 (snow that is not old); Oke 1987, Boundary Layer
/// Climates, table 1.1 (grass, its visible part; sea under a high sun).
double albedoOf(GroundName ground) {
  switch (ground) {
    case GroundName::snow:
      return 0.8;
    case GroundName::grass:
      return 0.1;
    case GroundName::sea:
      return 0.06;
  }
  return 0.0;
}

}  // namespace

bool AerosolAlbedo::read(const Value& in, double& out) const {
  const auto albedo = in.numberIn(kShare);
  if (!albedo)
    return in.mustBe("a number " + kShare.text(), "an aerosol cannot absorb or scatter more than it extinguishes");
  out = *albedo;
  return true;
}

Json AerosolAlbedo::schema() const { return numberSchema(kShare); }

bool Aerosol::read(const Value& in, AerosolSettings& out) const {
  if (const toml::table* table = in.node.as_table()) {
    TableReader reader(*table, "the aerosol", in.complaints);
    visitKeys(reader, out);
    return reader.rejectUnknown();
  }
  const auto beta = in.numberIn(kBeta);
  if (!beta)
    return in.mustBe("a number " + kBeta.text() + " or a table",
                     "it is the optical depth at 1000 nm, or { beta = 0.03, alpha = 1.3, albedo = 0.95, g = 0.7, "
                     "height = 1500 }");
  out.beta = *beta;
  return true;
}

Json Aerosol::schema() const { return {{"anyOf", {numberSchema(kBeta), tableSchema<AerosolSettings>()}}}; }

bool Ground::read(const Value& in, double& out) const {
  if (const auto name = memberNamedBy<GroundName>(in)) {
    out = albedoOf(*name);
    return true;
  }
  if (const toml::table* table = in.node.as_table()) {
    TableReader reader(*table, "the ground", in.complaints);
    GroundKeys keys;
    visitKeys(reader, keys);
    out = keys.albedo;
    return reader.rejectUnknown();
  }
  return in.mustBe("one of " + listNames(kNamesOf<GroundName>) + " or { albedo = 0.3 }",
                   didYouMean(in.string().value_or(""), kNamesOf<GroundName>));
}

Json Ground::schema() const { return {{"anyOf", {Choice<GroundName>{}.schema(), tableSchema<GroundKeys>()}}}; }

}  // namespace parhelion::kinds
