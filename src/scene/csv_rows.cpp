// SPDX-License-Identifier: Apache-2.0
#include "scene/csv_rows.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "math/number_text.h"
#include "scene/utf8.h"

namespace parhelion {

namespace {

constexpr std::size_t kMostBytes = 1 << 20;
constexpr std::size_t kMostQuoted = 60;
constexpr std::string_view kBlanks = " \t\r";

/// Whether a line that is no row of numbers may be one of titles: a row with a slip begins as a number does.
bool mayBeTitles(std::string_view line) { return std::string_view("0123456789+-.").find(line[0]) == line.npos; }

/// "12.5, 0.3"; none where something in it is no number.
std::optional<std::vector<double>> numbersOf(std::string_view line) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t comma = std::min(line.find(',', begin), line.size());
    const auto number = numberIn(trimmed(line.substr(begin, comma - begin), kBlanks));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    begin = comma + 1;
  }
  return numbers;
}

}  // namespace

std::optional<toml::array> csvRows(const std::filesystem::path& path, const CsvRule& rule, const Place& place,
                                   Complaints& complaints) {
  std::ifstream file(path);
  if (!file) {
    complaints.add(place, path.string() + " cannot be read", "it is looked for beside the scene");
    return std::nullopt;
  }
  toml::array rows;
  std::string line;
  std::vector<double> before;
  std::size_t bytes = 0;
  bool isFirst = true;
  for (int number = 1; std::getline(file, line); ++number) {
    bytes += line.size() + 1;
    const std::string_view text = trimmed(line, kBlanks);
    if (text.empty() || text.starts_with('#')) continue;
    auto row = numbersOf(text);
    const bool areTitles = !row && isFirst && mayBeTitles(text);
    isFirst = false;
    if (areTitles) continue;
    if (!row || row->size() < rule.least || row->size() > rule.most || !rule.accepts(*row, before) ||
        bytes > kMostBytes) {
      complaints.add(place, path.string() + ", line " + std::to_string(number) + ": must be " +
                                std::string(rule.mustBe) + ", not '" + std::string(text.substr(0, kMostQuoted)) + "'");
      return std::nullopt;
    }
    toml::array own;
    for (const double value : *row) own.push_back(value);
    rows.push_back(std::move(own));
    before = *std::move(row);
  }
  return rows;
}

}  // namespace parhelion
