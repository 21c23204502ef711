// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace parhelion::cli {

/// Degrees for a table, without the last bits that come from going through radians.
double tableDegrees(double radians);

/// Writes a whole file, or to stdout for "-". A file that was there is replaced only once all is written.
/// Throws std::runtime_error with the path and the reason.
void writeText(const std::string& path, std::string_view text);

}  // namespace parhelion::cli
