// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "picture/file_kind.h"

namespace parhelion::cli {

/// Prints the texts of a picture and, if there is one among them, what its scene holds. `path` is for messages.
void printTexts(const std::map<std::string, std::string>& text, const std::string& path);

/// Prints what a JPEG or PNG holds: size, camera, lens, field of view and date, and its texts. Returns the exit code.
/// Throws std::runtime_error.
int infoPhotograph(const std::string& path, const FileKind& kind);

}  // namespace parhelion::cli
