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

std::string didYouMean(std::string_view word, std::span<const std::string_view> accepted) {
  std::string_view closest;
  int closestDistance = 0;
  for (const std::string_view name : accepted) {
    const int limit = std::max(1, static_cast<int>(name.size()) / 3);
    const auto lengthDifference = std::abs(static_cast<long>(word.size()) - static_cast<long>(name.size()));
    if (lengthDifference > limit) continue;
    const int distance = editDistance(word, name);
    if (distance <= limit && (closest.empty() || distance < closestDistance)) {
      closest = name;
      closestDistance = distance;
    }
  }
  return closest.empty() ? "" : std::string("did you mean '").append(closest) + "'?";
}

}  // namespace parhelion
