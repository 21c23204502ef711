// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace parhelion {

/// JSON Schema (draft-04) of scene files, for editors that complete and check TOML.
std::string sceneSchema();

/// The tables that have this key, as users write them: "[sun] or [camera]"; empty where none has.
std::string tablesWithKey(std::string_view key);

/// Whether a scene has a table of that name: "camera".
bool isTable(std::string_view name);

}  // namespace parhelion
