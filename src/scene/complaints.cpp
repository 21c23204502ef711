// SPDX-License-Identifier: Apache-2.0
#include "scene/complaints.h"

#include <algorithm>
#include <cstdio>
#include <tuple>
#include <utility>

#include "scene/utf8.h"

namespace parhelion {

namespace {

constexpr int kMaxExcerpt = 100;           // code points of a line that an excerpt shows
constexpr std::size_t kMaxMessage = 1000;  // code points; messages may quote the file
constexpr std::size_t kMaxExcerpts = 100;  // later errors go without, so that a hostile file cannot stall the report

std::vector<std::string> splitLines(std::string_view text) {
  std::vector<std::string> lines;
  while (true) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.emplace_back(line);
    if (end == std::string_view::npos) return lines;
    text.remove_prefix(end + 1);
  }
}

/// `line` from its code point number `first` (from 0).
std::string_view dropCodePoints(std::string_view line, int first) {
  std::size_t at = 0;
  for (int i = 0; i < first && at < line.size(); ++i) at += decodeUtf8(line, at).length;
  return line.substr(at);
}

}  // namespace

std::size_t Complaints::addText(std::string_view name, std::string_view text) {
  texts_.push_back({std::string(name), splitLines(text)});
  return texts_.size() - 1;
}

void Complaints::addOverride(const SceneOverride& override) {
  texts_.push_back({override.name(), splitLines(override.text), override});
}

std::size_t Complaints::textNamed(std::string_view name) const {
  const auto found = std::find_if(texts_.rbegin(), texts_.rend(), [&](const Text& t) { return t.name == name; });
  return found == texts_.rend() ? 0 : static_cast<std::size_t>(texts_.rend() - found) - 1;
}

std::string Complaints::excerpt(const Place& place, const std::vector<std::string>& lines) const {
  if (place.line < 1 || place.line > static_cast<int>(lines.size())) return "";
  const std::string& line = lines[static_cast<std::size_t>(place.line - 1)];
  const int length = static_cast<int>(countCodePoints(line));

  // Of a long line, the part around the place.
  const int first = length > kMaxExcerpt ? std::max(0, place.column - 1 - kMaxExcerpt / 2) : 0;
  const std::string shown = printable(dropCodePoints(line, first), kMaxExcerpt);
  const int begin = std::clamp(place.column - 1 - first, 0, kMaxExcerpt);
  const int lineEnd = std::min(length - first, kMaxExcerpt);
  const int wanted = place.endLine == place.line ? place.endColumn - 1 - first : lineEnd;
  const int end = std::max(begin + 1, std::min(wanted, lineEnd));

  char margin[16];
  std::snprintf(margin, sizeof margin, "%5d | ", place.line);
  const std::string blank(std::string_view(margin).size() - 2, ' ');
  std::string caret(static_cast<std::size_t>(begin), ' ');
  caret += '^' + std::string(static_cast<std::size_t>(end - begin - 1), '~');
  return margin + shown + '\n' + blank + "| " + caret + '\n';
}

Complaints::Words Complaints::wordsFor(const Place& place, std::string_view message) const {
  const Text& text = texts_[place.text];
  const SceneOverride& override = text.override;
  if (override.option.empty()) return {place, message, text.lines};
  const std::string_view key = std::string_view(override.text).substr(0, override.text.find('='));
  const std::string named = "'" + std::string(key.substr(key.find_last_of('.') + 1)) + "': ";
  if (message.starts_with(named)) message.remove_prefix(named.size());
  if (override.word.empty()) return {{place.text}, message, {}};
  const int before = static_cast<int>(countCodePoints(override.text.substr(0, override.wordAt())));
  Place shown = place;
  shown.column = std::max(1, place.column - before);
  shown.endColumn = std::max(shown.column + 1, place.endColumn - before);
  return {shown, message, {override.word}};
}

void Complaints::add(const Place& place, std::string_view message, std::string_view hint) {
  const Words words = wordsFor(place, message);
  Diagnostic d;
  d.file = printable(texts_[place.text].name, kMaxMessage);
  d.line = words.place.line;
  d.column = words.place.column;
  d.message = printable(words.message, kMaxMessage);
  d.hint = printable(hint, kMaxMessage);
  if (complaints_.size() < kMaxExcerpts) d.excerpt = excerpt(words.place, words.lines);
  complaints_.push_back({place, std::move(d)});
}

Place Complaints::placeIn(const Place& value, std::string_view text, std::size_t at, std::size_t length) const {
  const std::vector<std::string>& lines = texts_[value.text].lines;
  if (value.line < 1 || value.line > static_cast<int>(lines.size())) return value;
  const std::string& line = lines[static_cast<std::size_t>(value.line - 1)];
  const std::size_t from = line.size() - dropCodePoints(line, value.column - 1).size(), found = line.find(text, from);
  if (found == std::string::npos || text.empty()) return value;
  const auto columnAt = [&](std::size_t byte) {
    return static_cast<int>(countCodePoints(std::string_view(line).substr(0, std::min(byte, line.size())))) + 1;
  };
  Place part = value;
  part.column = columnAt(found + at);
  part.endLine = part.line;
  part.endColumn = std::max(part.column + 1, columnAt(found + at + length));
  return part;
}

void Complaints::throwIfAny() {
  if (complaints_.empty()) return;
  const auto position = [](const Complaint& c) { return std::tuple(c.place.text, c.place.line, c.place.column); };
  std::stable_sort(complaints_.begin(), complaints_.end(),
                   [&](const Complaint& a, const Complaint& b) { return position(a) < position(b); });
  std::vector<Diagnostic> diagnostics;
  for (Complaint& c : complaints_) diagnostics.push_back(std::move(c.diagnostic));
  throw SceneError(std::move(diagnostics));
}

}  // namespace parhelion
