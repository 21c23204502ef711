// SPDX-License-Identifier: Apache-2.0
#include "view/lens_star.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/portable.h"
#include "picture/colour_space.h"

namespace parhelion {

namespace {

// Wavelengths of red, green and blue, nm: where the primaries of Rec.709 are nearest to the spectrum's.
constexpr std::array kWavelengths{611.0, 549.0, 464.0};
constexpr double kNanometresPerMillimetre = 1e6;
constexpr double kDazzling = 1000.0;  // times the median of the lit pixels
constexpr double kStep = 0.5;         // pixels along a ray

/// Length of all edges over the polygon's area, 1/mm.
double edgesOverArea(const LensAperture& lens) {
  const double half = kPi / lens.blades, radius = 0.5 * lens.diameter;
  return 2.0 / (radius * portable::cos(half));
}

double luminanceAt(const std::array<const std::vector<float>*, 3>& planes, std::size_t i) {
  double sum = 0.0;
  for (int c = 0; c < 3; ++c)
    sum += kRec709Luminance[c] * static_cast<double>((*planes[static_cast<std::size_t>(c)])[i]);
  return sum;
}

std::vector<std::size_t> dazzlingPixels(const Image& image) {
  const auto planes = image.rgb();
  std::vector<double> lit;
  for (std::size_t i = 0; i < image.pixels(); ++i)
    if (const double light = luminanceAt(planes, i); light > 0.0 && std::isfinite(light)) lit.push_back(light);
  if (lit.empty()) return {};
  const auto middle = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() / 2);
  std::nth_element(lit.begin(), middle, lit.end());
  std::vector<std::size_t> pixels;
  for (std::size_t i = 0; i < image.pixels(); ++i)
    if (const double light = luminanceAt(planes, i); light >= kDazzling * *middle && std::isfinite(light))
      pixels.push_back(i);
  return pixels;
}

/// Shares a number among the four pixels around a place, in pixels from the middle of the first one.
void addAround(const Vec2& place, float light, int width, int height, std::vector<float>& plane) {
  const double left = std::floor(place.x), top = std::floor(place.y);
  const auto u = static_cast<float>(place.x - left), v = static_cast<float>(place.y - top);
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      const int x = static_cast<int>(left) + i, y = static_cast<int>(top) + j;
      if (x < 0 || x >= width || y < 0 || y >= height) continue;
      plane[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] +=
          light * (i ? u : 1.0F - u) * (j ? v : 1.0F - v);
    }
}

}  // namespace

double starShare(const LensAperture& lens, double wavelength, double angle) {
  return std::min(1.0, wavelength / kNanometresPerMillimetre * edgesOverArea(lens) / (2.0 * kPi * kPi * angle));
}

std::vector<Vec2> starRays(const LensAperture& lens) {
  std::vector<Vec2> rays;
  const int count = lens.blades % 2 == 0 ? lens.blades : 2 * lens.blades;
  for (int k = 0; k < count; ++k) {
    const portable::SinCos turn = portable::sincos(2.0 * kPi * k / count);
    rays.emplace_back(turn.sin, turn.cos);
  }
  return rays;
}

std::size_t addLensStar(Image& image, double pixel, const LensAperture& lens) {
  const std::vector<std::size_t> sources = dazzlingPixels(image);
  const std::vector<Vec2> rays = starRays(lens);
  const double reach = std::hypot(image.width, image.height);
  // What a step along a ray holds of a source's light: shares from one distance to the next, the first from a pixel on.
  std::array<std::vector<float>, 3> steps;
  for (std::size_t c = 0; c < 3; ++c)
    for (double from = 1.0; from < reach; from += kStep)
      steps[c].push_back(static_cast<float>(
          (starShare(lens, kWavelengths[c], from * pixel) - starShare(lens, kWavelengths[c], (from + kStep) * pixel)) /
          static_cast<double>(rays.size())));
  constexpr std::array kNames{"R", "G", "B"};
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<float>& plane = *image.find(kNames[c]);
    const std::vector<float> before = plane;
    const auto stays = static_cast<float>(1.0 - starShare(lens, kWavelengths[c], pixel));
    for (const std::size_t source : sources) {
      plane[source] -= (1.0F - stays) * before[source];
      const Vec2 middle(static_cast<double>(source % static_cast<std::size_t>(image.width)),
                        static_cast<double>(source / static_cast<std::size_t>(image.width)));
      for (const Vec2& ray : rays)
        for (std::size_t k = 0; k < steps[c].size(); ++k) {
          const Vec2 place = middle + (1.0 + (static_cast<double>(k) + 0.5) * kStep) * ray;
          if (place.x < -1.0 || place.y < -1.0 || place.x > image.width || place.y > image.height) break;
          addAround(place, steps[c][k] * before[source], image.width, image.height, plane);
        }
    }
  }
  return sources.size();
}

}  // namespace parhelion
