// SPDX-License-Identifier: Apache-2.0
#include "sky/tally_info.h"

#include "math/rotation.h"

namespace parhelion {

void TallyInfo::visitTotals(SumVisitor& visitor) {
  visitor.visit(intercepted);
  visitor.visit(undeviated);
  for (LightTotal& total : interceptedXyz) visitor.visit(total);
}

double TallyInfo::undeviatedFraction() const {
  return intercepted.units() > 0 ? undeviated.value() / intercepted.value() : 0.0;
}

Vec3 TallyInfo::toSun() const { return skyDirection(0.0, sunElevation); }

std::string objectionToAdding(const TallyOrigin& a, const TallyOrigin& b) {
  const auto differ = [](const char* what, const auto& one, const auto& other) {
    return std::string(what) + " are " + std::to_string(one) + " and " + std::to_string(other);
  };
  if (a.numerics != b.numerics) return differ("the versions of their numerics", a.numerics, b.numerics);
  if (a.sceneHash != b.sceneHash) return "they are of different scenes";
  if (a.seed != b.seed) return differ("their seeds", a.seed, b.seed);
  if (const auto common = commonRays(a.rays, b.rays)) return wordsFor({*common}) + " are in both";
  return {};
}

std::string objectionToAdding(const TallyInfo& a, const TallyInfo& b) {
  if (a.symmetry != b.symmetry) {
    return "their symmetries are " + std::string(nameOf(a.symmetry)) + " and " + std::string(nameOf(b.symmetry));
  }
  if (a.camera != b.camera) return "they are of different cameras";
  if (a.white != b.white || a.sunElevation != b.sunElevation || a.sunDiameter != b.sunDiameter)
    return "they are of different suns";
  return objectionToAdding(static_cast<const TallyOrigin&>(a), static_cast<const TallyOrigin&>(b));
}

}  // namespace parhelion
