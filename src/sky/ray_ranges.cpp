// SPDX-License-Identifier: Apache-2.0
#include "sky/ray_ranges.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace parhelion {
namespace {

std::string wordsFor(const RayRange& range) {
  const std::string first = std::to_string(range.first);
  return range.count == 1 ? first : first + " to " + std::to_string(range.end() - 1);
}

}  // namespace

RayRanges joined(std::vector<RayRange> ranges) {
  std::erase_if(ranges, [](const RayRange& r) { return r.count == 0; });
  std::ranges::sort(ranges, {}, &RayRange::first);
  RayRanges result;
  for (const RayRange& range : ranges) {
    if (range.count > std::numeric_limits<std::uint64_t>::max() - range.first)
      throw std::invalid_argument("tally: ray numbers beyond 2^64");
    const std::uint64_t end = result.empty() ? 0 : result.back().end();
    if (range.first < end)
      throw std::invalid_argument(
          "tally: " + parhelion::wordsFor({{range.first, std::min(end, range.end()) - range.first}}) +
          " are counted twice");
    if (!result.empty() && range.first == end)
      result.back().count += range.count;
    else
      result.push_back(range);
  }
  return result;
}

std::uint64_t countOf(const RayRanges& ranges) {
  std::uint64_t sum = 0;
  for (const RayRange& range : ranges) sum += range.count;
  return sum;
}

std::optional<RayRange> commonRays(const RayRanges& a, const RayRanges& b) {
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    const std::uint64_t first = std::max(i->first, j->first), end = std::min(i->end(), j->end());
    if (first < end) return RayRange{first, end - first};
    i->end() < j->end() ? ++i : ++j;
  }
  return {};
}

RayRanges raysWithout(const RayRanges& all, const RayRanges& taken) {
  RayRanges rest;
  auto out = taken.begin();
  for (const RayRange& range : all) {
    std::uint64_t next = range.first;
    while (out != taken.end() && out->end() <= next) ++out;
    for (auto o = out; o != taken.end() && o->first < range.end(); ++o) {
      if (o->first > next) rest.push_back({next, o->first - next});
      next = o->end();
    }
    if (next < range.end()) rest.push_back({next, range.end() - next});
  }
  return rest;
}

std::string wordsFor(const RayRanges& ranges) {
  constexpr std::size_t kMostNamed = 4;
  if (ranges.empty()) return "no rays";
  std::string words = ranges.size() == 1 && ranges[0].count == 1 ? "ray " : "rays ";
  const std::size_t named = std::min(ranges.size(), ranges.size() == kMostNamed + 1 ? kMostNamed + 1 : kMostNamed);
  for (std::size_t i = 0; i < named; ++i) {
    if (i > 0) words += i + 1 == ranges.size() ? " and " : ", ";
    words += wordsFor(ranges[i]);
  }
  if (named < ranges.size()) words += " and " + std::to_string(ranges.size() - named) + " more ranges";
  return words;
}

}  // namespace parhelion
