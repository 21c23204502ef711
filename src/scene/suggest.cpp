// SPDX-License-Identifier: Apache-2.0
#include "scene/suggest.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace parhelion {

int editDistance(std::string_view a, std::string_view b) {
  std::vector<int> beforeLast(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], beforeLast[j - 2] + 1);
    }
    std::swap(beforeLast, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

namespace {

constexpr std::size_t kLeastPart = 3;  // letters; fewer are in many names

/// Whether the word is how the name begins, or one of its parts: "fov" and "horizontal" of "fov_horizontal".
bool isPartOf(std::string_view word, std::string_view name) {
  if (word.size() < kLeastPart) return false;
  const auto isDash = [&](std::size_t at) { return at >= name.size() || name[at] == '_' || name[at] == '-'; };
  const std::size_t at = name.find(word);
  return at == 0 || (at != std::string_view::npos && isDash(at - 1) && isDash(at + word.size()));
}

/// Whether one goes on where the other ends: "bins" and "bin".
bool goesOn(std::string_view a, std::string_view b) { return a.starts_with(b) || b.starts_with(a); }

/// "'a', 'b' or 'c'"; nothing of nothing.
std::string alternatives(const std::vector<std::string_view>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
    text.append("'").append(names[i]).append("'");
  }
  return text;
}

}  // namespace

std::string didYouMean(std::string_view word, std::span<const std::string_view> accepted) {
  std::string_view closest;
  int closestDistance = 0;
  for (const std::string_view name : accepted) {
    const int limit = std::max(1, static_cast<int>(name.size()) / 3);
    const auto lengthDifference = std::abs(static_cast<long>(word.size()) - static_cast<long>(name.size()));
    if (lengthDifference > limit) continue;
    const int distance = editDistance(word, name);
    const bool isCloser =
        distance < closestDistance || (distance == closestDistance && goesOn(word, name) && !goesOn(word, closest));
    if (distance <= limit && (closest.empty() || isCloser)) {
      closest = name;
      closestDistance = distance;
    }
  }
  std::vector<std::string_view> meant;
  if (!closest.empty()) meant = {closest};
  for (const std::string_view name : accepted)
    if (closest.empty() && isPartOf(word, name)) meant.push_back(name);
  return meant.empty() ? "" : "did you mean " + alternatives(meant) + "?";
}

}  // namespace parhelion
