// SPDX-License-Identifier: Apache-2.0
#include "scene/key_range.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "math/date_time.h"
#include "math/duration_text.h"
#include "math/number_text.h"
#include "math/range.h"
#include "scene/utf8.h"

namespace parhelion {

namespace {

// Steps by which the last value may miss the end: decimals such as 0.1 are not exact in binary.
constexpr double kStepSlack = 1e-9;
constexpr double kMaxExactInteger = 9007199254740992.0;  // 2^53

[[noreturn]] void refuse(std::string_view text, const std::string& reason) {
  throw std::invalid_argument("'" + std::string(text) + "': " + reason);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t end = text.find(separator); end != std::string_view::npos; end = text.find(separator)) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.push_back(text);
  return parts;
}

std::vector<double> numbers(std::string_view text, const std::vector<std::string_view>& parts) {
  std::vector<double> all;
  for (const std::string_view part : parts) {
    const std::string_view digits = trimmed(part);
    const std::optional<double> value = numberIn(digits);
    if (!value) refuse(text, "'" + std::string(digits) + "' is not a number; expected key=from:to:step or key=a,b,c");
    all.push_back(*value);
  }
  return all;
}

/// Adding 0 makes -0 a plain 0.
std::string valueText(double value) {
  if (std::abs(value) < kMaxExactInteger && value == std::trunc(value))
    return std::to_string(static_cast<long long>(value));
  return formatNumber(value + 0.0);
}

/// How many whole steps fit into a range.
std::size_t stepsIn(std::string_view text, double length, double step, const std::string& to) {
  const double steps = length / step;
  if (step == 0.0) refuse(text, "the step is 0");
  if (!std::isfinite(steps)) refuse(text, "the range is too long");
  if (steps < 0.0) refuse(text, "steps of " + valueText(step) + " lead away from " + to);
  if (steps >= static_cast<double>(kMaxFrames)) refuse(text, "more than " + std::to_string(kMaxFrames) + " values");
  return static_cast<std::size_t>(std::floor(steps + kStepSlack));
}

std::vector<std::string> rangeValues(std::string_view text, double from, double to, double step) {
  const std::size_t last = stepsIn(text, to - from, step, valueText(to));
  std::vector<std::string> values;
  for (std::size_t i = 0; i <= last; ++i) {
    // Rounding must not leave a residue such as 5e-17 where the range passes through zero.
    const double value = from + static_cast<double>(i) * step;
    values.push_back(valueText(std::abs(value) < kStepSlack * std::abs(step) ? 0.0 : value));
    if (i > 0 && values[i] == values[i - 1]) refuse(text, "the step is lost in 12 digits");
  }
  return values;
}

/// Splits at the colons or commas between dates, which hold colons themselves; the last part may be anything.
std::vector<std::string_view> splitDates(std::string_view text) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::string_view front = trimmed(text);
    const auto date = dateTimeAtFront(front);
    const std::string_view rest = date ? trimmed(front.substr(date->length)) : std::string_view();
    parts.push_back(rest.empty() ? front : front.substr(0, date->length));
    if (rest.empty() || (rest[0] != ':' && rest[0] != ',')) return rest.empty() ? parts : std::vector{front};
    text = rest.substr(1);
  }
}

DateTime dateIn(std::string_view text, std::string_view part) {
  const auto date = dateTimeAtFront(part);
  if (!date || date->length != part.size())
    refuse(text, "'" + std::string(part) +
                     "' is no date and time that exists, with its offset from UTC; expected "
                     "key=2026-12-21T09:00:00+01:00,... or key=from:to:step with a step such as 10min");
  return date->time;
}

/// "-10min" as seconds.
double stepOfTime(std::string_view text, std::string_view part) {
  const bool back = part.starts_with('-');
  const std::optional<double> size = secondsIn(back ? part.substr(1) : part);
  if (!size) refuse(text, "'" + std::string(part) + "' is no step of time such as 90s, 10min, 2h or 1d");
  return back ? -*size : *size;
}

std::vector<std::string> dateRange(std::string_view text, const std::vector<std::string_view>& parts) {
  if (parts.size() != 3) refuse(text, "a range is from:to:step");
  const DateTime from = dateIn(text, parts[0]), to = dateIn(text, parts[1]);
  const double start = unixSeconds(from), length = unixSeconds(to) - start, step = stepOfTime(text, parts[2]);
  const std::size_t count = stepsIn(text, length, step, textOf(to)) + 1;
  std::vector<std::string> values;
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(textOf(dateTimeAt(start + static_cast<double>(i) * step, from.offset)));
    if (i > 0 && values[i] == values[i - 1]) refuse(text, "the step is below a microsecond");
  }
  return values;
}

/// Of dates all have an offset of their own; those of a range have that of the first.
std::vector<std::string> dateValues(std::string_view text, std::string_view values) {
  const std::vector<std::string_view> parts = splitDates(values);
  const bool isRange = trimmed(values).substr(parts[0].size()).starts_with(':');
  if (isRange) return dateRange(text, parts);
  std::vector<std::string> list;
  for (const std::string_view part : parts) {
    const DateTime date = dateIn(text, part);
    list.push_back(textOf(dateTimeAt(unixSeconds(date), date.offset)));
  }
  return list;
}

/// Turns the wheels of a mileage counter, the last one fastest; false when all are back at 0.
bool advance(std::vector<std::size_t>& wheels, std::span<const KeyRange> ranges) {
  for (std::size_t k = ranges.size(); k-- > 0;) {
    if (++wheels[k] < ranges[k].values.size()) return true;
    wheels[k] = 0;
  }
  return false;
}

void requireEqualCounts(std::span<const KeyRange> ranges) {
  for (const KeyRange& range : ranges) {
    if (range.values.size() == ranges[0].values.size()) continue;
    throw std::invalid_argument(ranges[0].key + " has " + std::to_string(ranges[0].values.size()) + " values and " +
                                range.key + " has " + std::to_string(range.values.size()) +
                                ": keys go together, value by value (--product takes all combinations)");
  }
}

void requireFewFrames(std::span<const KeyRange> ranges) {
  std::size_t frames = 1;
  for (const KeyRange& range : ranges) {
    frames *= range.values.size();
    if (frames > kMaxFrames) throw std::invalid_argument("more than " + std::to_string(kMaxFrames) + " frames");
  }
}

}  // namespace

KeyRange parseKeyRange(std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::string_view key = trimmed(text.substr(0, std::min(equals, text.size())));
  if (equals == std::string_view::npos || key.empty()) refuse(text, "expected key=from:to:step or key=a,b,c");
  const std::string_view values = text.substr(equals + 1);
  if (beginsAsDate(trimmed(values))) return {std::string(key), dateValues(text, values)};
  if (values.find(':') != std::string_view::npos) {
    const std::vector<std::string_view> parts = split(values, ':');
    if (parts.size() != 3) refuse(text, "a range is from:to:step");
    const std::vector<double> bounds = numbers(text, parts);
    return {std::string(key), rangeValues(text, bounds[0], bounds[1], bounds[2])};
  }
  KeyRange list{std::string(key), {}};
  for (const double value : numbers(text, split(values, ','))) list.values.push_back(valueText(value));
  return list;
}

std::vector<std::vector<std::string>> sweepFrames(std::span<const KeyRange> ranges, bool product) {
  for (std::size_t i = 0; i < ranges.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (ranges[i].key == ranges[k].key) throw std::invalid_argument("the key " + ranges[i].key + " is given twice");
  if (!product) requireEqualCounts(ranges);
  if (product) requireFewFrames(ranges);

  std::vector<std::vector<std::string>> frames;
  std::vector<std::size_t> at(ranges.size(), 0);
  bool more = !ranges.empty();
  while (more) {
    std::vector<std::string>& frame = frames.emplace_back();
    for (std::size_t k = 0; k < ranges.size(); ++k) frame.push_back(ranges[k].key + "=" + ranges[k].values[at[k]]);
    if (product) {
      more = advance(at, ranges);
    } else {
      for (std::size_t& index : at) ++index;
      more = at[0] < ranges[0].values.size();
    }
  }
  return frames;
}

}  // namespace parhelion
