// SPDX-License-Identifier: Apache-2.0
#include "photo/added_halo.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "parallel/loops.h"
#include "picture/transfer.h"

namespace parhelion {
namespace {

/// A number in [0, 1) that looks random from sample to sample: the finalizer of SplitMix64 (Steele, Lea & Flood 2014).
double dither(std::size_t sample) {
  std::uint64_t z = (static_cast<std::uint64_t>(sample) + 1) * 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

const auto& linearOfCodes(std::uint8_t) { return srgbDecode8(); }
const auto& linearOfCodes(std::uint16_t) { return srgbDecode16(); }

/// Light added to one sample; says whether it ended beyond white.
bool brighten(float& sample, double light, std::size_t) {
  sample = static_cast<float>(sample + light);
  return false;
}

template <class Code>
bool brighten(Code& sample, double light, std::size_t index) {
  constexpr std::size_t kWhite = std::numeric_limits<Code>::max();
  const auto& linear = linearOfCodes(sample);
  const double wanted = linear[sample] + light;
  if (wanted >= linear[kWhite]) {
    sample = static_cast<Code>(kWhite);
    return wanted > linear[kWhite];
  }
  const auto above = std::upper_bound(linear.begin() + sample, linear.end(), wanted);
  const double lo = *(above - 1), share = (wanted - lo) / (*above - lo);
  sample = static_cast<Code>(above - linear.begin() - (dither(index) < share ? 0 : 1));
  return false;
}

template <class Sample>
AddedHaloReport addRow(std::vector<Sample>& samples, int channels, int width, int y, const AddedHalo& added) {
  AddedHaloReport report;
  for (int x = 0; x < width; ++x) {
    const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
    if (added.mask.sky[pixel] == 0) continue;
    const auto light = added.at(x, y);
    if (!light) ++report.uncovered;
    if (!light || *light == Vec3(0.0)) continue;
    bool changed = false, clipped = false;
    for (int c = 0; c < 3; ++c) {
      const std::size_t i = pixel * channels + c;
      const Sample before = samples[i];
      clipped |= brighten(samples[i], (*light)[c], i);
      changed |= samples[i] != before;
    }
    report.touched += changed ? 1 : 0;
    report.clipped += clipped ? 1 : 0;
  }
  return report;
}

}  // namespace

std::optional<Vec3> AddedHalo::at(int x, int y) const {
  const auto light = halo.at({x + 0.5, y + 0.5});
  if (!light) return std::nullopt;
  return *light * perRadiance * (mask.sky[static_cast<std::size_t>(y) * mask.width + x] / 255.0);
}

AddedHaloReport& AddedHaloReport::operator+=(const AddedHaloReport& other) {
  touched += other.touched;
  clipped += other.clipped;
  uncovered += other.uncovered;
  return *this;
}

AddedHaloReport addHalo(Photograph& photograph, const AddedHalo& added) {
  if (added.mask.width != photograph.width || added.mask.height != photograph.height)
    throw std::invalid_argument("the mask does not have the photograph's size");
  return std::visit(
      [&](auto& samples) {
        return sumOverRows(photograph.height,
                           [&](int y) { return addRow(samples, photograph.channels, photograph.width, y, added); });
      },
      photograph.samples);
}

}  // namespace parhelion
