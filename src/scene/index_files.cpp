// SPDX-License-Identifier: Apache-2.0
#include "scene/index_files.h"

#include <algorithm>
#include <string>
#include <vector>

#include "optics/ice.h"
#include "optics/tables.h"
#include "scene/csv_rows.h"
#include "scene/value.h"

namespace parhelion {

namespace {

// Of continuous light a table must cover what is bright: less than 2e-3 of sunlight, as the eye weighs it, lies beyond.
constexpr double kBrightFirst = 400.0, kBrightLast = 700.0;  // nm

/// Wavelengths of the light, nm, rising.
std::vector<double> wavelengthsOf(const SpectrumSettings& spectrum) {
  if (const auto* one = std::get_if<MonochromaticSpectrum>(&spectrum)) return {one->wavelength};
  std::vector<double> all;
  if (const auto* lines = std::get_if<LineSpectrum>(&spectrum))
    all = lines->wavelengths;
  else
    for (int w = kVisibleFirst; w <= kVisibleLast; ++w) all.push_back(w);
  std::ranges::sort(all);
  return all;
}

/// "from 450 to 650 nm"
std::string rangeText(double from, double to) {
  return "from " + formatNumber(from) + " to " + formatNumber(to) + " nm";
}

}  // namespace

bool isIndexRow(std::span<const double> row, std::span<const double> before) {
  const bool isAlike = before.empty() || (row.size() == before.size() && row[0] > before[0]);
  return isAlike && row[0] > 0.0 && kIndexRange.contains(row[1]) && (row.size() < 3 || Range{}.contains(row[2]));
}

bool readIndexFile(toml::table& root, const std::filesystem::path& folder, Complaints& complaints) {
  toml::table* ice = root["ice"].as_table();
  const toml::node* node = ice ? ice->get("index") : nullptr;
  const auto name = node ? node->value_exact<std::string>() : std::nullopt;
  if (!name || !name->ends_with(".csv")) return false;
  const Place place = placeOf(node->source(), complaints);
  auto rows = csvRows(folder / *name, {2, 3, isIndexRow, kIndexRow}, place, complaints);
  if (rows && rows->empty()) complaints.add(place, (folder / *name).string() + " has no rows");
  complaints.throwIfAny();
  ice->insert_or_assign("index", toml::table{{"table", *std::move(rows)}});
  return true;
}

void checkIndex(const toml::table& root, const Scene& scene, Complaints& complaints) {
  const toml::node* node = root["ice"]["index"].node();
  if (!node) return;
  const Place place = placeOf(node->source(), complaints);
  const std::vector<double> light = wavelengthsOf(scene.sun.spectrum);
  const bool isContinuous = light.size() > static_cast<std::size_t>(kVisibleLast - kVisibleFirst);
  if (const auto* table = std::get_if<IndexTable>(&scene.ice.index)) {
    const double first = isContinuous ? kBrightFirst : light.front(), last = isContinuous ? kBrightLast : light.back();
    const double from = table->nodes.front().wavelength, to = table->nodes.back().wavelength;
    if (first < from || last > to)
      complaints.add(place, "the index is known " + rangeText(from, to) + ", and needed " + rangeText(first, last),
                     "add rows to its table, or choose a 'spectrum' of [sun] within it");
    return;
  }
  for (const double wavelength : light) {
    const double index = refractiveIndex(scene.ice, wavelength);
    if (kIndexRange.contains(index)) continue;
    complaints.add(place,
                   "the index at " + formatNumber(wavelength) + " nm must be " + kIndexRange.text() + ", not " +
                       formatNumber(index),
                   "the formulas count wavelengths in micrometres");
    return;
  }
}

}  // namespace parhelion
