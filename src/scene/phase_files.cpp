// SPDX-License-Identifier: Apache-2.0
#include "scene/phase_files.h"

#include <optional>
#include <string>

#include "scene/csv_rows.h"
#include "scene/named_files.h"

namespace parhelion {

namespace {

/// The pairs of a file; none where it has been complained about.
std::optional<toml::array> pairsOf(const std::filesystem::path& path, const Place& place, Complaints& complaints) {
  const auto accepts = [](std::span<const double> row, std::span<const double> before) {
    return row[0] > (before.empty() ? -1.0 : before[0]) && row[0] <= 180.0 && row[1] >= 0.0;
  };
  auto pairs = csvRows(path,
                       {2, 2, accepts,
                        "angle,value with an angle above the one before, up to 180 degrees, and a value that is not "
                        "negative"},
                       place, complaints);
  if (!pairs) return std::nullopt;
  const auto angleOf = [](const toml::node& row) { return row.as_array()->get(0)->value<double>(); };
  if (pairs->size() >= 2 && angleOf(pairs->front()) == 0.0 && angleOf(pairs->back()) == 180.0) return pairs;
  complaints.add(place, path.string() + ": must begin at 0 degrees and end at 180");
  return std::nullopt;
}

}  // namespace

bool readPhaseFiles(toml::table& root, const std::filesystem::path& folder, Complaints& complaints) {
  return putFiles(
      root, "phase", [](const std::string& name) { return name.ends_with(".csv"); },
      [&](const std::string& name, const Place& place) { return pairsOf(folder / name, place, complaints); },
      complaints);
}

}  // namespace parhelion
