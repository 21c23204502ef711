// SPDX-License-Identifier: Apache-2.0
#include "view/glare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

#include "math/conventions.h"
#include "math/portable.h"

namespace parhelion {
namespace {

constexpr double kInnermost = radians(0.1), kWidest = radians(100.0);
constexpr double kOctaves = 0.5;  // between neighbouring Gaussians
constexpr double kFinest = 0.3;   // pixels: what is narrower stays within its pixel

/// strength / t^power, t in degrees: a term of the equation.
struct PowerLaw {
  int power;  // 1, 2 or 3
  double strength;
};

std::array<PowerLaw, 3> termsOf(const Eye& eye) {
  const double ageing = 1.0 + std::pow(eye.age / 62.5, 4.0);
  return {{{3, 10.0}, {2, 5.0 * ageing}, {1, 0.1 * eye.pigmentation * ageing}}};
}

/// The gamma function of half a power.
double gammaOfHalf(int power) {
  constexpr double kRoot = 1.0 / std::numbers::inv_sqrtpi;
  return power == 1 ? kRoot : power == 2 ? 1.0 : 0.5 * kRoot;
}

/// Light per unit of ln(sigma) in Gaussians of that width. With u = a^2 / (2 sigma^2),
///   (1 + (t/a)^2)^(-s/2) = integral of 2 u^(s/2) e^(-u) / gamma(s/2) * exp(-t^2 / (2 sigma^2)) d ln(sigma),
/// and such a Gaussian holds 2 pi sigma^2 of light.
double densityAt(double sigma, const PowerLaw& term) {
  const double u = 0.5 * (kInnermost / sigma) * (kInnermost / sigma);
  const double peak = term.strength / std::pow(degrees(kInnermost), term.power);
  const double weight = 2.0 * std::pow(u, 0.5 * term.power) * portable::exp(-u) / gammaOfHalf(term.power);
  return peak * weight * 2.0 * kPi * sigma * sigma;
}

/// Half of a symmetric kernel: the weight of the middle, then of its neighbours on one side.
std::vector<float> gaussianTaps(double sigma) {
  const auto radius = static_cast<int>(std::ceil(4.0 * sigma + 0.5));
  std::vector<double> taps;
  double sum = 0.0;
  for (int i = 0; i <= radius; ++i) {
    // The share of a pixel, not the value in its middle: right for narrow ones, too.
    const double scale = std::numbers::sqrt2 * sigma;
    taps.push_back(0.5 * (std::erf((i + 0.5) / scale) - std::erf((i - 0.5) / scale)));
    sum += i == 0 ? taps.back() : 2.0 * taps.back();
  }
  std::vector<float> normalised;
  for (const double tap : taps) normalised.push_back(static_cast<float>(tap / sum));
  return normalised;
}

/// A plane with a margin of two pixels all around, in which light that has left the picture is kept for the rim.
struct Plane {
  static constexpr int kMargin = 2;

  Plane(int innerWidth, int innerHeight)
      : width(innerWidth + 2 * kMargin),
        height(innerHeight + 2 * kMargin),
        samples(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  float* row(int y) { return samples.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
  const float* row(int y) const {
    return samples.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
  }

  int width, height;
  std::vector<float> samples;
};

/// Adds `share` of a plane blurred by a Gaussian of variance `variance` to another plane; dark outside.
void addBlurred(const Plane& from, Plane& to, double variance, double share) {
  const std::vector<float> taps = gaussianTaps(std::sqrt(variance));
  const int radius = static_cast<int>(taps.size()) - 1;
  Plane rows = from;
  for (int y = 0; y < from.height; ++y) {
    const float* in = from.row(y);
    float* out = rows.row(y);
    for (int x = 0; x < from.width; ++x) out[x] = taps[0] * in[x];
    for (int i = 1; i <= radius && i < from.width; ++i) {
      const float tap = taps[static_cast<std::size_t>(i)];
      for (int x = i; x < from.width; ++x) out[x] += tap * in[x - i];
      for (int x = 0; x + i < from.width; ++x) out[x] += tap * in[x + i];
    }
  }
  for (int y = 0; y < from.height; ++y) {
    float* out = to.row(y);
    for (int i = -radius; i <= radius; ++i) {
      if (y + i < 0 || y + i >= from.height) continue;
      const float tap = static_cast<float>(share) * taps[static_cast<std::size_t>(std::abs(i))];
      const float* in = rows.row(y + i);
      for (int x = 0; x < from.width; ++x) out[x] += tap * in[x];
    }
  }
}

/// A plane of half the size: means of 4 x 4 pixels by 1, 3, 3, 1, which leave light's centre where it is. Pixel 0
/// inside begins where it does in the finer plane.
Plane halved(const Plane& fine) {
  const auto half = [](int size) { return (size - 2 * Plane::kMargin + 1) / 2; };
  Plane coarse(half(fine.width), half(fine.height));
  constexpr int kShift = Plane::kMargin + 1;  // the margin of the coarse plane is twice as wide
  constexpr std::array<float, 4> kTaps{0.125F, 0.375F, 0.375F, 0.125F};
  Plane narrow(half(fine.width), fine.height - 2 * Plane::kMargin);
  for (int y = 0; y < fine.height; ++y)
    for (int x = 0; x < narrow.width; ++x) {
      float sum = 0.0F;
      for (int i = 0; i < 4; ++i)
        if (const int u = 2 * x - kShift + i; u >= 0 && u < fine.width)
          sum += kTaps[static_cast<std::size_t>(i)] * fine.row(y)[u];
      narrow.row(y)[x] = sum;
    }
  for (int y = 0; y < coarse.height; ++y)
    for (int i = 0; i < 4; ++i)
      if (const int v = 2 * y - kShift + i; v >= 0 && v < fine.height)
        for (int x = 0; x < coarse.width; ++x)
          coarse.row(y)[x] += kTaps[static_cast<std::size_t>(i)] * narrow.row(v)[x];
  return coarse;
}

/// Adds a coarse plane to a finer one by linear interpolation, which keeps its light.
void addDoubled(const Plane& coarse, Plane& fine) {
  constexpr int kShift = Plane::kMargin;
  for (int y = 0; y < fine.height; ++y) {
    const int v = (y + kShift) / 2, toward = (y + kShift) % 2 == 0 ? -1 : 1;
    const float* near = coarse.row(std::min(v, coarse.height - 1));
    const float* far = coarse.row(std::clamp(v + toward, 0, coarse.height - 1));
    float* out = fine.row(y);
    for (int x = 0; x < fine.width; ++x) {
      const int u = std::min((x + kShift) / 2, coarse.width - 1);
      const int w = std::clamp(u + ((x + kShift) % 2 == 0 ? -1 : 1), 0, coarse.width - 1);
      out[x] += 0.5625F * near[u] + 0.1875F * (near[w] + far[u]) + 0.0625F * far[w];
    }
  }
}

}  // namespace

double glareVeil(double angle, const Eye& eye) {
  double veil = 0.0;
  for (const PowerLaw& term : termsOf(eye)) veil += term.strength / std::pow(degrees(angle), term.power);
  return veil;
}

std::vector<BlurredShare> glareOf(const Eye& eye) {
  const double step = kOctaves * std::numbers::ln2;
  std::vector<BlurredShare> shares;
  for (double sigma = kWidest; sigma > 0.2 * kInnermost; sigma /= std::exp2(kOctaves)) {
    double density = 0.0;
    for (const PowerLaw& term : termsOf(eye)) density += densityAt(sigma, term);
    shares.push_back({sigma, step * density});
  }
  std::reverse(shares.begin(), shares.end());
  return shares;
}

void spreadLight(std::vector<float>& plane, int width, int height, std::span<const BlurredShare> inPixels) {
  if (plane.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    throw std::invalid_argument("glare: the plane has another size");
  constexpr double kCoarsen = 3.0;  // pixels: what is wider is done in the next coarser picture

  std::vector<Plane> light, veils;
  light.emplace_back(width, height);
  for (int y = 0; y < height; ++y)
    std::copy_n(plane.begin() + static_cast<std::ptrdiff_t>(y) * width, width,
                light[0].row(y + Plane::kMargin) + Plane::kMargin);
  double scale = 1.0, stays = 1.0;
  for (const BlurredShare& part : inPixels) {
    stays -= part.share;
    while (part.sigma / scale > kCoarsen && std::min(light.back().width, light.back().height) > 4 * Plane::kMargin) {
      light.push_back(halved(light.back()));
      scale *= 2.0;
    }
    while (veils.size() < light.size())
      veils.emplace_back(light[veils.size()].width - 2 * Plane::kMargin,
                         light[veils.size()].height - 2 * Plane::kMargin);
    // The variance that comes by itself, in pixels of this level: of halving and of doubling three quarters of a finer
    // pixel's square each time, and of the coarse pixel's own size.
    const double own = scale > 1.0 ? (1.0 - 1.0 / (scale * scale)) / 2.0 + 1.0 / 12.0 : 0.0;
    const double sigma = part.sigma / scale;
    addBlurred(light.back(), veils.back(), std::max(sigma * sigma - own, 0.01), part.share);
  }
  for (std::size_t level = veils.size(); level-- > 1;) addDoubled(veils[level], veils[level - 1]);
  for (int y = 0; y < height; ++y) {
    float* out = plane.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    const float* veil = veils.empty() ? nullptr : veils[0].row(y + Plane::kMargin) + Plane::kMargin;
    for (int x = 0; x < width; ++x) out[x] = static_cast<float>(stays) * out[x] + (veil ? veil[x] : 0.0F);
  }
}

void addGlare(Image& image, double pixel, const Eye& eye) {
  std::vector<BlurredShare> inPixels;
  for (const BlurredShare& part : glareOf(eye))
    if (part.sigma > kFinest * pixel) inPixels.push_back({part.sigma / pixel, part.share});
  for (Channel& channel : image.channels)
    if (channel.name == "R" || channel.name == "G" || channel.name == "B")
      spreadLight(channel.samples, image.width, image.height, inPixels);
}

}  // namespace parhelion
