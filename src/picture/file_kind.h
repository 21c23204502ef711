// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace parhelion {

/// What a file is, as far as its first bytes tell.
struct FileKind {
  enum class Family { empty, text, jpeg, png, exr, otherPicture, otherBinary };

  Family family;
  const char* name;  // with its article: "a JPEG picture"

  /// Whether readPhotograph() reads it.
  bool isPhotograph() const { return family == Family::jpeg || family == Family::png || family == Family::exr; }
};

/// The kind of a file that begins with these bytes. Text is what has no byte of value 0, or begins as UTF-16 does.
FileKind kindOf(std::string_view start);

/// The first bytes of a file, as many as kindOf() looks at. None for what is no regular file: reading would take them
/// out of a pipe. None where it cannot be read, too.
std::string startOfFile(const std::filesystem::path& path);

}  // namespace parhelion
