// SPDX-License-Identifier: Apache-2.0
#include "scene/phase_files.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "math/number_text.h"
#include "scene/named_files.h"

namespace parhelion {

namespace {

constexpr std::size_t kMostBytes = 1 << 20;

/// "12.5,0.3"
std::optional<std::pair<double, double>> pairIn(std::string_view line) {
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
  const std::size_t comma = std::min(line.find(','), line.size());
  std::string_view rest = line.substr(std::min(comma + 1, line.size()));
  rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  const auto first = numberIn(line.substr(0, comma)), second = numberIn(rest);
  if (!first || !second) return std::nullopt;
  return std::pair(*first, *second);
}

/// The pairs of a file; none where it has been complained about.
std::optional<toml::array> pairsOf(const std::filesystem::path& path, const Place& place, Complaints& complaints) {
  std::ifstream file(path);
  if (!file) {
    complaints.add(place, path.string() + " cannot be read", "it is looked for beside the scene");
    return std::nullopt;
  }
  toml::array pairs;
  std::string line;
  double before = -1.0;
  std::size_t bytes = 0;
  for (int number = 1; std::getline(file, line); ++number) {
    bytes += line.size() + 1;
    if (line.starts_with('#')) continue;
    const auto pair = pairIn(line);
    if (!pair && number == 1) continue;  // titles
    if (!pair || !(pair->first > before) || !(pair->first <= 180.0) || !(pair->second >= 0.0) || bytes > kMostBytes) {
      complaints.add(place, path.string() + ", line " + std::to_string(number) +
                                ": must be angle,value with an angle above the one before, up to 180 degrees, and a "
                                "value that is not negative");
      return std::nullopt;
    }
    before = pair->first;
    pairs.push_back(toml::array{pair->first, pair->second});
  }
  if (pairs.size() >= 2 && pairs[0].as_array()->get(0)->value<double>() == 0.0 && before == 180.0) return pairs;
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
