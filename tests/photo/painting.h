// SPDX-License-Identifier: Apache-2.0
#pragma once

// Brushes of the painted landscapes: random numbers, fractal noise and lines, soft shapes on a canvas in linear light.

#include <array>
#include <cstdint>
#include <vector>

#include "picture/image.h"
#include "random_stream.h"

namespace parhelion {

using Colour = std::array<double, 3>;  // linear R, G, B

Colour mix(const Colour& a, const Colour& b, double share);
Colour scaled(const Colour& a, double factor);

/// Uniform numbers of one picture.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : stream_(seed, 0, RandomPurpose::population) {}
  double between(double low, double high) { return low + (high - low) * stream_.next(); }
  double normal();

 private:
  RandomStream stream_;
};

/// Fractal noise: octaves of value noise, each of half the size and half the height, about -1 to 1.
class FractalNoise {
 public:
  explicit FractalNoise(Dice& dice);
  double at(double x, double y, int octaves) const;  // x, y in units of the largest waves

 private:
  double wave(double x, double y) const;
  std::vector<double> lattice_;
};

/// A line from left to right by midpoint displacement: heights in pixels from the top, one a column.
std::vector<double> ridgeLine(Dice& dice, int width, double level, double swing, double roughness);

/// A picture and how much of each pixel is sky.
struct Canvas {
  Canvas(int w, int h) : width(w), height(h), colours(size()), sky(size(), 1.0F) {}
  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  /// Land of so much coverage over what is there.
  void cover(int x, int y, double coverage, const Colour& colour);
  /// A line that gets thinner from one end to the other, ends round.
  void stroke(double x0, double y0, double x1, double y1, double radius0, double radius1, const Colour& colour);

  int width, height;
  std::vector<Colour> colours;
  std::vector<float> sky;
};

/// What the camera makes of it: darker corners, shot and read noise, white at 1, 8 bits through the sRGB curve.
Image exposed(const Canvas& canvas, Dice& dice, double vignetting, double noise);

}  // namespace parhelion
