// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace parhelion::cli {

/// Throws std::runtime_error if a file cannot be written at `path`; changes nothing there. For long runs, before they
/// start. "-" and "" are fine.
void requireWritable(const std::string& path);

/// Writes a whole file, or to stdout for "-". A file that was there is replaced only once all is written.
/// Throws std::runtime_error with the path and the reason.
void writeText(const std::string& path, std::string_view text);

}  // namespace parhelion::cli
