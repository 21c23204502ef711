// SPDX-License-Identifier: Apache-2.0
#include "scene/phase_files.h"

#include <charconv>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace parhelion {

namespace {

constexpr std::size_t kMostBytes = 1 << 20;

/// "12.5,0.3"
std::optional<std::pair<double, double>> pairIn(std::string_view line) {
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
  const char* const end = line.data() + line.size();
  std::pair<double, double> pair;
  const auto first = std::from_chars(line.data(), end, pair.first);
  const char* at = first.ptr;
  if (first.ec != std::errc() || at == end || *at++ != ',') return std::nullopt;
  while (at != end && *at == ' ') ++at;
  const auto second = std::from_chars(at, end, pair.second);
  if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
  return pair;
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
  bool any = false;
  toml::array* populations = root["population"].as_array();
  for (std::size_t i = 0; populations && i < populations->size(); ++i) {
    toml::table* population = (*populations)[i].as_table();
    const toml::node* phase = population ? population->get("phase") : nullptr;
    const auto name = phase ? phase->value_exact<std::string>() : std::nullopt;
    if (!name || !name->ends_with(".csv")) continue;
    any = true;
    auto pairs = pairsOf(folder / *name, placeOf(phase->source(), complaints), complaints);
    if (pairs) population->insert_or_assign("phase", std::move(*pairs));
  }
  complaints.throwIfAny();
  return any;
}

}  // namespace parhelion
