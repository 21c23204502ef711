// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <toml++/toml.h>

#include "scene/complaints.h"

namespace parhelion {

/// Puts the values of files in the place of their names: of populations whose `phase` is "file.csv", a line
/// "angle,value" for each pair of the list, in degrees. Lines that begin with # and one of titles are passed over.
/// Names count from `folder`. Returns whether there was any, and complains about what cannot be read.
bool readPhaseFiles(toml::table& root, const std::filesystem::path& folder, Complaints& complaints);

}  // namespace parhelion
