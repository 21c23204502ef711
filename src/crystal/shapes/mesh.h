// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "crystal/crystal_mesh.h"
#include "crystal/distributions.h"
#include "crystal/mesh/mesh_from_obj.h"

namespace parhelion {

/// A crystal from a closed mesh.
struct MeshSettings {
  static constexpr std::string_view kName = "mesh";
  std::string obj = {};                                  // as objText() writes it
  std::shared_ptr<const CrystalMesh> crystal = nullptr;  // what meshFromObj() makes of it
};

inline CrystalMesh meshOf(const MeshSettings& settings) {
  if (!settings.crystal) throw std::invalid_argument("a crystal of shape \"mesh\" needs a mesh");
  return *settings.crystal;
}
inline std::optional<AngleDistribution> stretchOf(const MeshSettings&) { return std::nullopt; }
inline bool hasEndsAlike(const MeshSettings&) { return false; }
inline bool isHexagonal(const MeshSettings&) { return false; }

}  // namespace parhelion
