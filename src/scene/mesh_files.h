// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <toml++/toml.h>

#include "scene/complaints.h"

namespace parhelion {

/// Puts meshes in the place of the files' names: of populations whose `mesh` is a line, the OBJ of that name, with
/// nothing but its vertices and faces. Names count from `folder`. Returns whether there was any, and complains about
/// what cannot be read or is no crystal.
bool readMeshFiles(toml::table& root, const std::filesystem::path& folder, Complaints& complaints);

}  // namespace parhelion
