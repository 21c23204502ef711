// SPDX-License-Identifier: Apache-2.0
#include "view/beside.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "view/colour_difference.h"

namespace parhelion {
namespace {

constexpr int kGap = 4;  // pixels
constexpr std::uint8_t kGapGrey = 128;
constexpr double kFullSwingShare = 0.995;  // of the pixels that differ, which are to be within the range

void place(const Preview& picture, int left, Preview& sheet) {
  const std::size_t top = static_cast<std::size_t>(sheet.height - picture.height) / 2;
  const std::size_t row = 3 * static_cast<std::size_t>(picture.width), wide = 3 * static_cast<std::size_t>(sheet.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height); ++y)
    std::copy_n(picture.rgb.begin() + static_cast<std::ptrdiff_t>(y * row), row,
                sheet.rgb.begin() + static_cast<std::ptrdiff_t>((top + y) * wide + 3 * static_cast<std::size_t>(left)));
}

/// The gain at which all that differs in the bulk of the pixels fits in the picture.
double fittingGain(const Image& one, const Image& other) {
  const auto a = one.rgb(), b = other.rgb();
  std::vector<float> sizes;
  for (std::size_t i = 0; i < one.pixels(); ++i) {
    float greatest = 0.0F;
    for (std::size_t c = 0; c < 3; ++c) {
      const float size = std::abs((*a[c])[i] - (*b[c])[i]);
      if (std::isfinite(size)) greatest = std::max(greatest, size);
    }
    // Where both are alike, as outside the image circle or the mask, there is nothing to be seen.
    if (greatest > 0.0F) sizes.push_back(greatest);
  }
  if (sizes.empty()) return 0.0;
  const auto rank = static_cast<std::ptrdiff_t>(kFullSwingShare * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), sizes.begin() + rank, sizes.end());
  return (1.0 - kMidGrey) / sizes[static_cast<std::size_t>(rank)];
}

}  // namespace

Preview beside(const Preview& left, const Preview& right) {
  Preview sheet{left.width + kGap + right.width, std::max(left.height, right.height), {}, 0};
  sheet.rgb.resize(3 * static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height));
  const Preview gap{kGap, sheet.height,
                    std::vector<std::uint8_t>(static_cast<std::size_t>(3 * kGap * sheet.height), kGapGrey), 0};
  place(left, 0, sheet);
  place(gap, left.width, sheet);
  place(right, left.width + kGap, sheet);
  return sheet;
}

LightDifference minus(const Image& one, const Image& other, std::optional<double> gain) {
  if (one.width != other.width || one.height != other.height)
    throw std::invalid_argument("the pictures have different sizes");
  const auto a = one.rgb(), b = other.rgb();
  LightDifference result{{one.width, one.height, {}}, gain ? *gain : fittingGain(one, other)};
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<float>& plane = result.picture.planes[c];
    plane.resize(one.pixels());
    for (std::size_t i = 0; i < plane.size(); ++i) {
      const double difference = static_cast<double>((*a[c])[i]) - (*b[c])[i];
      const double shown = std::isfinite(difference) ? kMidGrey + result.gain * difference : kMidGrey;
      plane[i] = static_cast<float>(std::clamp(shown, 0.0, 1.0));
    }
  }
  return result;
}

}  // namespace parhelion
