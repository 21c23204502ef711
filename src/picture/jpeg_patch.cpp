// SPDX-License-Identifier: Apache-2.0
#include "picture/jpeg_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <new>
#include <stdexcept>

#include "math/conventions.h"
#include "math/portable.h"
#include "picture/atomic_file.h"
#include "picture/jpeg.h"
#include "picture/jpeg_coefficients.h"
#include "picture/stored_picture.h"
#include "picture/upright.h"

namespace parhelion {
namespace {

constexpr int kSide = 8;  // of a block, samples
using Block = std::array<double, kSide * kSide>;
using Weights = std::array<double, 3>;  // of R, G, B in a component

/// The transform's orthonormal base (ITU-T T.81, A.3.3): [u][x], cosines of u half waves over a block.
Block cosines() {
  Block base;
  for (int u = 0; u < kSide; ++u) {
    const double scale = std::sqrt((u == 0 ? 1.0 : 2.0) / kSide);
    for (int x = 0; x < kSide; ++x) base[u * kSide + x] = scale * portable::cos((2 * x + 1) * u * kPi / (2 * kSide));
  }
  return base;
}

/// Along both axes: F = base f base^T.
Block transform(const Block& samples) {
  static const Block base = cosines();
  Block rows{}, both{};
  for (int y = 0; y < kSide; ++y) {
    for (int u = 0; u < kSide; ++u) {
      for (int x = 0; x < kSide; ++x) rows[y * kSide + u] += samples[y * kSide + x] * base[u * kSide + x];
    }
  }
  for (int v = 0; v < kSide; ++v) {
    for (int y = 0; y < kSide; ++y) {
      for (int u = 0; u < kSide; ++u) both[v * kSide + u] += base[v * kSide + y] * rows[y * kSide + u];
    }
  }
  return both;
}

/// Y, Cb, Cr of Rec.601 as JFIF has them (ITU-T T.871, 7), without their offset, or R, G, B.
Weights weightsOf(std::size_t component, bool isRgb) {
  Weights weights{};
  if (isRgb) {
    weights[component] = 1.0;
    return weights;
  }
  const std::array<Weights, 3> all{{{0.299, 0.587, 0.114},
                                    {-0.299 / 1.772, -0.587 / 1.772, 0.886 / 1.772},
                                    {0.701 / 1.402, -0.587 / 1.402, -0.114 / 1.402}}};
  return all[component];
}

/// Two pictures of the same size, RGB.
struct Pair {
  int width, height;
  const std::vector<std::uint8_t>& before;
  const std::vector<std::uint8_t>& after;

  std::size_t at(int x, int y) const { return 3 * (static_cast<std::size_t>(y) * width + x); }
  int change(std::size_t sample) const { return after[sample] - before[sample]; }

  bool same(int left, int top, int right, int bottom) const {
    for (int y = top; y < bottom; ++y) {
      const auto row = before.begin();
      if (!std::equal(row + at(left, y), row + at(right, y), after.begin() + at(left, y))) return false;
    }
    return true;
  }

  bool greyChange() const {
    for (std::size_t i = 0; i < before.size(); i += 3) {
      if (change(i) != change(i + 1) || change(i) != change(i + 2)) return false;
    }
    return true;
  }
};

/// The change of a component's sample: the mean over its pixels. What lies beyond the picture is as its border.
double sampleChange(const Pair& pair, const JpegCoefficients::Component& component, const Weights& weights, int column,
                    int row) {
  std::array<int, 3> sum{};
  for (int j = 0; j < component.down; ++j) {
    const int y = std::min(row * component.down + j, pair.height - 1);
    for (int i = 0; i < component.across; ++i) {
      const std::size_t at = pair.at(std::min(column * component.across + i, pair.width - 1), y);
      for (std::size_t c = 0; c < 3; ++c) sum[c] += pair.change(at + c);
    }
  }
  return (weights[0] * sum[0] + weights[1] * sum[1] + weights[2] * sum[2]) / (component.across * component.down);
}

void addRounded(std::int16_t* coefficients, const Block& change, const std::array<std::uint16_t, 64>& steps) {
  for (std::size_t k = 0; k < change.size(); ++k) {
    coefficients[k] = static_cast<std::int16_t>(coefficients[k] + std::lround(change[k] / steps[k]));
  }
}

void patch(JpegCoefficients& jpeg, std::size_t index, const Pair& pair) {
  const JpegCoefficients::Component& component = jpeg.components()[index];
  const Weights weights = weightsOf(index, jpeg.isRgb());
  const int across = kSide * component.across, down = kSide * component.down;  // pixels
  for (int v = 0; v < component.blocksHigh; ++v) {
    std::int16_t* const row = jpeg.row(index, v);
    for (int u = 0; u < component.blocksWide; ++u) {
      if (pair.same(u * across, v * down, std::min((u + 1) * across, pair.width),
                    std::min((v + 1) * down, pair.height))) {
        continue;
      }
      Block samples;
      for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
          samples[y * kSide + x] = sampleChange(pair, component, weights, u * kSide + x, v * kSide + y);
        }
      }
      addRounded(row + static_cast<std::ptrdiff_t>(u) * kSide * kSide, transform(samples), component.steps);
    }
  }
}

bool isJpeg(const std::filesystem::path& path) {
  std::array<char, 3> start{};
  std::ifstream(path, std::ios::binary).read(start.data(), start.size());
  return start == std::array{'\xff', '\xd8', '\xff'};
}

/// The orientation that undoes another: all but the quarter turns are their own opposites.
int opposite(int orientation) { return orientation == 6 ? 8 : orientation == 8 ? 6 : orientation; }

bool writePatched(const Output& output, const std::filesystem::path& original, Photograph changed,
                  std::string_view comment) {
  const StoredPicture stored = readJpeg(original);
  turnUpright(changed, opposite(readExif(stored.exif).orientation));
  JpegCoefficients jpeg(original);
  const int width = jpeg.width(), height = jpeg.height();
  if (width != stored.picture.width || height != stored.picture.height || width != changed.width ||
      height != changed.height) {
    throw std::invalid_argument("the changed picture has another size than the JPEG");
  }
  const Pair pair{width, height, std::get<std::vector<std::uint8_t>>(stored.picture.samples),
                  std::get<std::vector<std::uint8_t>>(changed.samples)};
  if (!jpeg.repeatable() || (jpeg.components().size() == 1 && !pair.greyChange())) return false;
  for (std::size_t i = 0; i < jpeg.components().size(); ++i) patch(jpeg, i, pair);
  AtomicFile file(output);
  jpeg.write(file, comment);
  file.commit();
  return true;
}

}  // namespace

bool writePatchedJpeg(const Output& output, const std::filesystem::path& original, const Photograph& changed,
                      std::string_view comment) {
  if (!isJpeg(original)) return false;
  if (changed.channels != 3 || !std::holds_alternative<std::vector<std::uint8_t>>(changed.samples)) {
    throw std::invalid_argument("the changed picture is not RGB in 8 bits");
  }
  try {
    return writePatched(output, original, changed, comment);
  } catch (const std::bad_alloc&) {
    throw pictureError(original, "not enough memory");
  }
}

}  // namespace parhelion
