// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include <toml++/toml.h>

#include "math/range.h"
#include "scene/complaints.h"
#include "scene/scene.h"

namespace parhelion {

inline constexpr Range kIndexRange{1.0, 3.0, true};

/// What isIndexRow() asks for.
inline constexpr std::string_view kIndexRow =
    "wavelength,n or wavelength,n,k, all alike: a wavelength in nm above the one before, n above 1 and at most 3, k "
    "not "
    "negative";

/// Whether a row of a table of indices may stand after another one, which is empty for the first.
bool isIndexRow(std::span<const double> row, std::span<const double> before);

/// Puts the table of a file in the place of its name, which is [ice]'s `index`. Names count from `folder`. Returns
/// whether there was one, and complains about what cannot be read.
bool readIndexFile(toml::table& root, const std::filesystem::path& folder, Complaints& complaints);

/// Complains about an index that is not known, or is none, at wavelengths of the scene's light.
void checkIndex(const toml::table& root, const Scene& scene, Complaints& complaints);

}  // namespace parhelion
