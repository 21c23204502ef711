// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include <toml++/toml.h>

#include "scene/complaints.h"

namespace parhelion {

/// What the rows of a file must be.
struct CsvRule {
  std::size_t least, most;  // numbers in a row
  std::function<bool(std::span<const double> row, std::span<const double> before)> accepts;
  std::string_view mustBe;  // "angle,value with …", for complaints
};

/// The rows of a file as a list of lists. Empty lines, those that begin with #
/// and one of titles before the first row are passed over. None where it has
/// been complained about.
std::optional<toml::array> csvRows(const std::filesystem::path& path, const CsvRule& rule, const Place& place,
                                   Complaints& complaints);

}  // namespace parhelion
