// SPDX-License-Identifier: Apache-2.0
#include "painting.h"

#include <algorithm>
#include <cmath>

#include "math/conventions.h"
#include "math/portable.h"
#include "picture/tone.h"

namespace parhelion {

Colour mix(const Colour& a, const Colour& b, double share) {
  return {a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share, a[2] + (b[2] - a[2]) * share};
}

Colour scaled(const Colour& a, double factor) { return {a[0] * factor, a[1] * factor, a[2] * factor}; }

double Dice::normal() {
  const double radius = std::sqrt(-2.0 * portable::log(stream_.next()));
  return radius * portable::cos(2.0 * kPi * stream_.next());
}

namespace {
constexpr int kLattice = 128;  // nodes a side; the noise repeats after them
}

FractalNoise::FractalNoise(Dice& dice) : lattice_(kLattice * kLattice) {
  for (double& node : lattice_) node = dice.between(-1.0, 1.0);
}

double FractalNoise::wave(double x, double y) const {
  const double x0 = std::floor(x), y0 = std::floor(y);
  const auto node = [&](double dx, double dy) {
    const auto column = static_cast<std::size_t>(static_cast<std::int64_t>(x0 + dx) & (kLattice - 1));
    const auto row = static_cast<std::size_t>(static_cast<std::int64_t>(y0 + dy) & (kLattice - 1));
    return lattice_[row * kLattice + column];
  };
  const auto ease = [](double t) { return t * t * (3.0 - 2.0 * t); };
  const double u = ease(x - x0), v = ease(y - y0);
  const double top = node(0, 0) + (node(1, 0) - node(0, 0)) * u;
  const double bottom = node(0, 1) + (node(1, 1) - node(0, 1)) * u;
  return top + (bottom - top) * v;
}

double FractalNoise::at(double x, double y, int octaves) const {
  double sum = 0.0, height = 0.7;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += height * wave(x, y);
    x = 2.0 * x + 17.3;
    y = 2.0 * y + 5.9;
    height *= 0.5;
  }
  return sum;
}

std::vector<double> ridgeLine(Dice& dice, int width, double level, double swing, double roughness) {
  constexpr int kSteps = 2048;
  std::vector<double> line(kSteps + 1, level);
  line.front() += swing * dice.between(-1.0, 1.0);
  line.back() += swing * dice.between(-1.0, 1.0);
  for (int step = kSteps; step > 1; step /= 2) {
    for (int i = step / 2; i < kSteps; i += step) {
      const auto a = static_cast<std::size_t>(i - step / 2), b = static_cast<std::size_t>(i + step / 2);
      line[static_cast<std::size_t>(i)] = 0.5 * (line[a] + line[b]) + swing * dice.between(-1.0, 1.0);
    }
    swing *= roughness;
  }
  std::vector<double> heights(static_cast<std::size_t>(width));
  for (int x = 0; x < width; ++x) {
    const double place = (x + 0.5) / width * kSteps;
    const auto i = static_cast<std::size_t>(place);
    heights[static_cast<std::size_t>(x)] = line[i] + (line[i + 1] - line[i]) * (place - static_cast<double>(i));
  }
  return heights;
}

void Canvas::cover(int x, int y, double coverage, const Colour& colour) {
  if (x < 0 || y < 0 || x >= width || y >= height || coverage <= 0.0) return;
  const double share = std::min(coverage, 1.0);
  colours[index(x, y)] = mix(colours[index(x, y)], colour, share);
  sky[index(x, y)] *= static_cast<float>(1.0 - share);
}

void Canvas::stroke(double x0, double y0, double x1, double y1, double radius0, double radius1, const Colour& colour) {
  const double reach = std::max(radius0, radius1) + 1.0;
  const double dx = x1 - x0, dy = y1 - y0, length2 = std::max(dx * dx + dy * dy, 1e-9);
  const int top = std::max(0, static_cast<int>(std::min(y0, y1) - reach));
  const int bottom = std::min(height - 1, static_cast<int>(std::max(y0, y1) + reach));
  const int left = std::max(0, static_cast<int>(std::min(x0, x1) - reach));
  const int right = std::min(width - 1, static_cast<int>(std::max(x0, x1) + reach));
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      const double px = x + 0.5 - x0, py = y + 0.5 - y0;
      const double along = std::clamp((px * dx + py * dy) / length2, 0.0, 1.0);
      const double distance = std::hypot(px - along * dx, py - along * dy);
      const double radius = radius0 + (radius1 - radius0) * along;
      // A line thinner than a pixel covers only part of it.
      cover(x, y, std::clamp(radius - distance + 0.5, 0.0, std::min(1.0, 2.0 * radius)), colour);
    }
  }
}

Image exposed(const Canvas& canvas, Dice& dice, double vignetting, double noise) {
  Image image{canvas.width, canvas.height, {}};
  for (const char* name : {"R", "G", "B"}) image.add(name);
  const double halfX = 0.5 * canvas.width, halfY = 0.5 * canvas.height;
  for (int y = 0; y < canvas.height; ++y) {
    for (int x = 0; x < canvas.width; ++x) {
      const double r2 = ((x - halfX) * (x - halfX) + (y - halfY) * (y - halfY)) / (halfX * halfX + halfY * halfY);
      for (std::size_t c = 0; c < 3; ++c) {
        const double light = canvas.colours[canvas.index(x, y)][c] * (1.0 - vignetting * r2 * r2);
        const double noisy = light + noise * std::sqrt(std::max(light, 0.0) + 0.01) * dice.normal();
        const double code = std::round(255.0 * srgbEncode(std::clamp(noisy, 0.0, 1.0))) / 255.0;
        const double linear = code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
        image.channels[c].samples[canvas.index(x, y)] = static_cast<float>(linear);
      }
    }
  }
  return image;
}

}  // namespace parhelion
