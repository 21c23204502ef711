// SPDX-License-Identifier: Apache-2.0
#include "view/gaussian_blur.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace parhelion {
namespace {

constexpr int kPasses = 4;
constexpr int kLanes = 16;  // neighbouring rows or columns, blurred together: one cache line of floats

/// A stretch of as many rows, or columns, side by side.
using Line = std::vector<std::array<float, kLanes>>;

/// Weights `inner` at distances up to `radius`, `edge` one farther; they add up to 1.
struct ExtendedBox {
  int radius;
  double inner, edge;
};

/// The box of one pass (Gwosdek et al. 2011, eq. 8 ff.): the widest plain one whose variance is too small, and just as
/// much of its two neighbours as is lacking.
ExtendedBox extendedBox(double sigma) {
  const double variance = sigma * sigma / kPasses;
  const double r = std::floor(0.5 * (std::sqrt(1.0 + 12.0 * variance) - 1.0));
  const double share = (2.0 * r + 1.0) * (r * (r + 1.0) - 3.0 * variance) / (6.0 * (variance - (r + 1.0) * (r + 1.0)));
  const double total = 2.0 * (r + share) + 1.0;
  return {static_cast<int>(r), 1.0 / total, share / total};
}

/// The running sum is kept in double: floats of a picture add and subtract in it without a trace.
void boxPass(const Line& in, Line& out, const ExtendedBox& box) {
  const int last = static_cast<int>(in.size()) - 1;
  const auto at = [&](int i) -> const std::array<float, kLanes>& {
    return in[static_cast<std::size_t>(std::clamp(i, 0, last))];
  };
  std::array<double, kLanes> sum{};
  for (int i = -box.radius; i <= box.radius; ++i)
    for (std::size_t l = 0; l < kLanes; ++l) sum[l] += at(i)[l];

  for (int i = 0; i <= last; ++i) {
    const auto &before = at(i - box.radius - 1), &leaving = at(i - box.radius), &after = at(i + box.radius + 1);
    std::array<float, kLanes>& result = out[static_cast<std::size_t>(i)];
    for (std::size_t l = 0; l < kLanes; ++l) {
      const double entering = after[l];
      result[l] = static_cast<float>(box.inner * sum[l] + box.edge * (entering + before[l]));
      sum[l] += entering - leaving[l];
    }
  }
}

/// Blurs the plane along lines of `length` samples a `step` apart; the `lines` lines begin a `stride` apart.
void blurLines(std::vector<float>& plane, int length, std::size_t step, int lines, std::size_t stride,
               const ExtendedBox& box) {
  Line line(static_cast<std::size_t>(length)), next(line.size());
  for (int first = 0; first < lines; first += kLanes) {
    const auto begin = static_cast<std::size_t>(first);
    const auto count = static_cast<std::size_t>(std::min(kLanes, lines - first));
    for (std::size_t i = 0; i < line.size(); ++i)
      for (std::size_t l = 0; l < count; ++l) line[i][l] = plane[i * step + (begin + l) * stride];
    for (int pass = 0; pass < kPasses; ++pass) {
      boxPass(line, next, box);
      std::swap(line, next);
    }
    for (std::size_t i = 0; i < line.size(); ++i)
      for (std::size_t l = 0; l < count; ++l) plane[i * step + (begin + l) * stride] = line[i][l];
  }
}

}  // namespace

void blurGaussian(std::vector<float>& plane, int width, int height, double sigma) {
  if (!(sigma > 0.0 && sigma <= kMaxBlur)) throw std::invalid_argument("blur: sigma must be above 0 and at most 4096");
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  if (plane.size() != w * h) throw std::invalid_argument("blur: the plane has another size");
  const ExtendedBox box = extendedBox(sigma);
  blurLines(plane, width, 1, height, w, box);
  blurLines(plane, height, w, width, 1, box);
}

}  // namespace parhelion
