// SPDX-License-Identifier: Apache-2.0
#include "render/wanted_rays.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace parhelion {

RayRange sliceOf(std::uint64_t rays, int bundleSize, std::uint64_t i, std::uint64_t count) {
  __extension__ using Wide = unsigned __int128;
  const auto size = static_cast<std::uint64_t>(bundleSize), bundles = (rays + size - 1) / size;
  const auto cut = [&](std::uint64_t slices) {
    return std::min(rays, static_cast<std::uint64_t>(Wide{bundles} * slices / count) * size);
  };
  return {cut(i - 1), cut(i) - cut(i - 1)};
}

void requireBundleStart(const RayRange& range, int bundleSize) {
  const auto size = static_cast<std::uint64_t>(bundleSize);
  const std::uint64_t before = range.first / size * size;
  if (range.first == before) return;
  throw std::invalid_argument("rays of this scene come in bundles of " + std::to_string(size) +
                              ", and a range must start with the first ray of one, for one " + std::to_string(before) +
                              " or " + std::to_string(before + size) + ", not " + std::to_string(range.first));
}

}  // namespace parhelion
