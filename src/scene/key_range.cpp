// SPDX-License-Identifier: Apache-2.0
#include "scene/key_range.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

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

std::vector<std::string> rangeValues(std::string_view text, double from, double to, double step) {
  const double steps = (to - from) / step;
  if (step == 0.0) refuse(text, "the step is 0");
  if (!std::isfinite(steps)) refuse(text, "the range is too long");
  if (steps < 0.0) refuse(text, "steps of " + valueText(step) + " lead away from " + valueText(to));
  if (steps >= static_cast<double>(kMaxFrames)) refuse(text, "more than " + std::to_string(kMaxFrames) + " values");
  const auto last = static_cast<std::size_t>(std::floor(steps + kStepSlack));
  std::vector<std::string> values;
  for (std::size_t i = 0; i <= last; ++i) {
    // Rounding must not leave a residue such as 5e-17 where the range passes through zero.
    const double value = from + static_cast<double>(i) * step;
    values.push_back(valueText(std::abs(value) < kStepSlack * std::abs(step) ? 0.0 : value));
    if (i > 0 && values[i] == values[i - 1]) refuse(text, "the step is lost in 12 digits");
  }
  return values;
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
