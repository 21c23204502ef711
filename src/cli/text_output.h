// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace parhelion::cli {

/// For long runs, before they start: throws CLI::ValidationError if two of the outputs are one file or one of them is
/// the file `input`, and std::runtime_error if one cannot be written. Changes nothing. Empty names do not count, "-" is
/// stdout.
void requireOutputs(const std::string& input, const std::vector<std::string>& outputs);

/// Degrees for a table, without the last bits that come from going through radians.
double tableDegrees(double radians);

/// Writes a whole file, or to stdout for "-". A file that was there is replaced only once all is written.
/// Throws std::runtime_error with the path and the reason.
void writeText(const std::string& path, std::string_view text);

}  // namespace parhelion::cli
