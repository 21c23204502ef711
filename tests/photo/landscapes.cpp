// SPDX-License-Identifier: Apache-2.0
#include "landscapes.h"

#include <algorithm>
#include <cmath>

#include "math/conventions.h"
#include "math/portable.h"
#include "painting.h"
#include "picture/tone.h"

namespace parhelion {

namespace {

struct Painter {
  Canvas canvas;
  Dice dice;
  FractalNoise noise;
  double size;  // pixels, of the picture's height: every length scales with it
  Colour zenith{}, horizon{};

  Painter(std::uint64_t seed, int width, int height) : canvas(width, height), dice(seed), noise(dice), size(height) {}

  template <class F>
  void eachPixel(const F& f) {
    for (int y = 0; y < canvas.height; ++y) {
      for (int x = 0; x < canvas.width; ++x) f(x, y, canvas.colours[canvas.index(x, y)]);
    }
  }

  void gradient(const Colour& top, const Colour& bottom, double horizonHeight) {
    zenith = top;
    horizon = bottom;
    eachPixel([&](int, int y, Colour& colour) {
      const double t = std::min(1.0, y / (horizonHeight * size));
      colour = mix(top, bottom, t * t * (2.0 - t));
    });
  }

  void blueSky() {
    const double light = dice.between(0.7, 1.1);
    gradient(scaled({dice.between(0.08, 0.18), dice.between(0.22, 0.34), dice.between(0.5, 0.7)}, light),
             scaled({dice.between(0.45, 0.62), dice.between(0.58, 0.7), dice.between(0.72, 0.82)}, light), 0.75);
  }

  /// Clouds where the noise is above `threshold`, from nothing to all within `softness`; streaks where flat.
  void clouds(const Colour& lit, const Colour& shaded, double threshold, double softness, double flatness) {
    const double scale = dice.between(2.0, 4.0) / size, shift = dice.between(0.0, 50.0);
    eachPixel([&](int x, int y, Colour& colour) {
      const double density = noise.at(x * scale + shift, y * scale * flatness, 6);
      const double cover = std::clamp((density - threshold) / softness, 0.0, 1.0);
      const double shade = 0.5 + 0.9 * noise.at(x * scale * 2.0 + 31.0, (y + 0.04 * size) * scale * 2.0 * flatness, 5);
      colour = mix(colour, mix(lit, shaded, std::clamp(shade, 0.0, 1.0)), cover);
    });
  }

  void glow(double sunX, double sunY, const Colour& light) {
    eachPixel([&](int x, int y, Colour& colour) {
      const double r = std::hypot(x - sunX, 1.4 * (y - sunY)) / size;
      const double strength = 0.8 * portable::exp(-r / 0.16) + 0.5 * portable::exp(-r / 0.5) + (r < 0.012 ? 5.0 : 0.0);
      for (std::size_t c = 0; c < 3; ++c) colour[c] += strength * light[c];
    });
  }

  /// Land below a line, mixed with the haze before it.
  void land(const std::vector<double>& line, const Colour& colour, double contrast, double haze) {
    const double scale = dice.between(10.0, 20.0) / size, shift = dice.between(0.0, 50.0);
    for (int y = 0; y < canvas.height; ++y) {
      for (int x = 0; x < canvas.width; ++x) {
        const double coverage = y + 1.0 - line[static_cast<std::size_t>(x)];
        if (coverage <= 0.0) continue;
        const double texture = 1.0 + contrast * noise.at(x * scale + shift, y * scale * 1.5 + shift, 5);
        canvas.cover(x, y, coverage, mix(scaled(colour, std::max(texture, 0.1)), horizon, haze));
      }
    }
  }

  std::vector<double> line(double level, double swing, double roughness = 0.55) {
    return ridgeLine(dice, canvas.width, level * size, swing * size, roughness);
  }

  Colour soil(double light) {
    return scaled({dice.between(0.10, 0.25), dice.between(0.12, 0.25), dice.between(0.04, 0.14)}, light);
  }

  void branch(double x, double y, double angle, double length, double radius, int depth, const Colour& bark) {
    const double x1 = x + length * portable::cos(angle), y1 = y - length * portable::sin(angle);
    canvas.stroke(x, y, x1, y1, radius, radius * 0.7, bark);
    if (depth == 0) return;
    const int children = dice.between(0.0, 1.0) < 0.6 ? 2 : 3;
    for (int i = 0; i < children; ++i) {
      const double turn = dice.between(-0.65, 0.65);
      branch(x1, y1, angle + turn, length * dice.between(0.65, 0.88), std::max(radius * 0.66, 0.25), depth - 1, bark);
    }
  }

  void crown(double x, double y, double radius, const Colour& leaves) {
    const int count = 900;
    for (int i = 0; i < count; ++i) {
      const double r = radius * std::sqrt(dice.between(0.0, 1.0)), turn = dice.between(0.0, 2.0 * kPi);
      const double px = x + r * portable::cos(turn), py = y + 0.8 * r * portable::sin(turn);
      const double leaf = radius * dice.between(0.02, 0.06);
      canvas.stroke(px, py, px + leaf, py + leaf * dice.between(-1.0, 1.0), leaf, 0.6 * leaf,
                    scaled(leaves, dice.between(0.4, 1.6)));
    }
  }

  /// Everything below `shore` mirrors what is above, dimmer, with waves.
  void water(double shore, double dimming) {
    const Canvas above = canvas;
    const int first = static_cast<int>(shore * size);
    for (int y = first; y < canvas.height; ++y) {
      const double depth = y - first;
      for (int x = 0; x < canvas.width; ++x) {
        const double wave = noise.at(x * 12.0 / size, depth * 60.0 / size, 4) * (0.002 * size + 0.04 * depth);
        const int from = std::clamp(static_cast<int>(first - 1 - depth + wave), 0, canvas.height - 1);
        canvas.colours[canvas.index(x, y)] =
            mix(scaled(above.colours[above.index(x, from)], dimming), {0.03, 0.05, 0.06}, 0.12);
        canvas.sky[canvas.index(x, y)] = 0.0F;
      }
    }
  }

  void house(double left, double right, double roof, const Colour& wall, const Colour& windows) {
    for (int y = static_cast<int>(roof); y < canvas.height; ++y) {
      for (int x = static_cast<int>(left) - 1; x <= static_cast<int>(right); ++x) {
        const double coverage = std::min({1.0, y + 1.0 - roof, x + 1.0 - left, right - x});
        const double u = std::fmod((x - left) / size, 0.03), v = std::fmod((y - roof) / size, 0.045);
        const bool window = u > 0.012 && u < 0.024 && v > 0.018 && v < 0.036;
        canvas.cover(x, y, coverage, window ? windows : wall);
      }
    }
  }
};

void paintRidges(Painter& p) {
  p.blueSky();
  for (int i = 0; i < 3; ++i) p.land(p.line(0.45 + 0.15 * i, 0.1), p.soil(1.0), 0.5, 0.45 - 0.2 * i);
}

void paintHaze(Painter& p) {
  p.blueSky();
  const double farthest = p.dice.between(0.82, 0.92);
  for (int i = 0; i < 6; ++i) p.land(p.line(0.38 + 0.1 * i, 0.06), p.soil(0.8), 0.4, farthest * (1.0 - i / 6.0));
}

void paintTrees(Painter& p, bool leaves) {
  p.blueSky();
  p.land(p.line(0.72, 0.03), p.soil(1.0), 0.5, 0.5);
  p.land(p.line(0.82, 0.03), p.soil(0.8), 0.6, 0.0);
  const double width = p.canvas.width;
  for (int i = 0; i < 4; ++i) {
    const double x = width * (0.12 + 0.25 * i + p.dice.between(-0.05, 0.05)), y = 0.87 * p.size;
    const double height = p.size * p.dice.between(0.12, 0.2);
    const Colour bark = scaled({0.06, 0.045, 0.03}, p.dice.between(0.5, 1.5));
    p.branch(x, y, 0.5 * kPi, height, 0.012 * p.size, leaves ? 4 : 8, bark);
    if (leaves) p.crown(x, y - 1.9 * height, 0.8 * height, p.soil(0.7));
  }
}

void paintBrightClouds(Painter& p) {
  p.blueSky();
  p.clouds({0.95, 0.95, 0.97}, {0.55, 0.58, 0.64}, p.dice.between(-0.1, 0.15), 0.08, 1.6);
  p.land(p.line(0.6, 0.08), p.soil(1.5), 0.5, 0.3);
  p.land(p.line(0.75, 0.05), p.soil(2.0), 0.6, 0.0);
}

void paintDarkClouds(Painter& p) {
  const double light = p.dice.between(0.6, 1.0);
  p.gradient(scaled({0.3, 0.36, 0.45}, light), scaled({0.7, 0.68, 0.6}, light), 0.7);
  p.clouds({0.22, 0.23, 0.26}, {0.06, 0.065, 0.08}, p.dice.between(-0.1, 0.1), 0.1, 1.8);
  p.land(p.line(0.62, 0.07), p.soil(1.0), 0.5, 0.15);
  p.land(p.line(0.78, 0.04), p.soil(1.2), 0.6, 0.0);
}

void paintSunset(Painter& p) {
  p.gradient({0.06, 0.1, 0.28}, {0.75, 0.38, 0.14}, 0.66);
  p.glow(p.canvas.width * p.dice.between(0.2, 0.8), 0.58 * p.size, {1.0, 0.6, 0.25});
  p.clouds({0.5, 0.2, 0.12}, {0.1, 0.06, 0.09}, p.dice.between(0.0, 0.2), 0.15, 4.0);
  p.land(p.line(0.62, 0.05), {0.05, 0.035, 0.04}, 0.4, 0.12);
  p.land(p.line(0.75, 0.04), {0.03, 0.025, 0.02}, 0.6, 0.0);
}

void paintSnow(Painter& p) {
  p.blueSky();
  const auto line = p.line(0.45, 0.12, 0.58);
  p.land(line, scaled(mix(p.horizon, {0.8, 0.8, 0.82}, 0.7), p.dice.between(0.9, 1.1)), 0.25, 0.0);
  // Rock where the slopes are steep.
  const double scale = 7.0 / p.size;
  for (int y = 0; y < p.canvas.height; ++y) {
    for (int x = 0; x < p.canvas.width; ++x) {
      const double rock = p.noise.at(x * scale, y * scale * 0.6, 6) - 0.12;
      const double inside = p.canvas.sky[p.canvas.index(x, y)] == 0.0F ? 1.0 : 0.0;
      p.canvas.cover(x, y, inside * std::clamp(rock / 0.1, 0.0, 1.0), {0.12, 0.11, 0.12});
    }
  }
  p.land(p.line(0.8, 0.04), p.soil(0.6), 0.6, 0.0);
}

void paintLake(Painter& p) {
  p.blueSky();
  if (p.dice.between(0.0, 1.0) < 0.5) p.clouds({0.9, 0.9, 0.92}, {0.6, 0.62, 0.66}, 0.2, 0.3, 1.6);
  p.land(p.line(0.42, 0.06), p.soil(1.0), 0.5, 0.45);
  p.land(p.line(0.5, 0.03), p.soil(0.6), 0.6, 0.1);
  p.water(0.57, p.dice.between(0.75, 0.95));
}

void paintSea(Painter& p) {
  p.blueSky();
  p.clouds({0.9, 0.9, 0.92}, {0.6, 0.62, 0.66}, 0.1, 0.3, 2.5);
  const Colour sea = mix({0.03, 0.12, 0.16}, p.horizon, p.dice.between(0.1, 0.6));
  p.land(std::vector<double>(static_cast<std::size_t>(p.canvas.width), p.dice.between(0.45, 0.65) * p.size), sea, 0.25,
         0.0);
}

void paintTown(Painter& p) {
  p.blueSky();
  p.clouds({0.9, 0.9, 0.92}, {0.6, 0.62, 0.66}, 0.15, 0.3, 1.6);
  p.land(p.line(0.68, 0.03), p.soil(1.0), 0.5, 0.3);
  for (double left = -0.05 * p.size; left < p.canvas.width;) {
    const double right = left + p.size * p.dice.between(0.06, 0.2);
    const double shade = p.dice.between(0.05, 0.75);
    p.house(left, right, p.size * p.dice.between(0.3, 0.65),
            {shade, shade * p.dice.between(0.8, 1.0), shade * p.dice.between(0.6, 0.95)}, {0.05, 0.06, 0.08});
    left = right + p.size * p.dice.between(0.0, 0.05);
  }
  p.land(p.line(0.88, 0.01), {0.12, 0.12, 0.12}, 0.4, 0.0);
}

void paint(Landscape kind, Painter& p) {
  switch (kind) {
    case Landscape::ridges:
      return paintRidges(p);
    case Landscape::haze:
      return paintHaze(p);
    case Landscape::bareTrees:
      return paintTrees(p, false);
    case Landscape::leafyTrees:
      return paintTrees(p, true);
    case Landscape::brightClouds:
      return paintBrightClouds(p);
    case Landscape::darkClouds:
      return paintDarkClouds(p);
    case Landscape::sunset:
      return paintSunset(p);
    case Landscape::snow:
      return paintSnow(p);
    case Landscape::lake:
      return paintLake(p);
    case Landscape::sea:
      return paintSea(p);
    case Landscape::town:
      return paintTown(p);
  }
}

}  // namespace

std::string_view nameOf(Landscape kind) {
  constexpr std::array<std::string_view, kLandscapes.size()> kNames{
      "ridges", "haze", "bare trees", "leafy trees", "bright clouds", "dark clouds",
      "sunset", "snow", "lake",       "sea",         "town"};
  return kNames[static_cast<std::size_t>(kind)];
}

Scenery paintLandscape(Landscape kind, std::uint64_t seed, int width, int height) {
  Painter painter(seed * 16 + static_cast<std::uint64_t>(kind), width, height);
  paint(kind, painter);
  const double vignetting = painter.dice.between(0.0, 0.35), noise = painter.dice.between(0.005, 0.02);
  return {exposed(painter.canvas, painter.dice, vignetting, noise), painter.canvas.sky};
}

Photograph photographOf(const Image& linear) {
  std::vector<std::uint8_t> samples(3 * linear.pixels());
  const auto planes = linear.rgb();
  for (std::size_t i = 0; i < linear.pixels(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double light = std::clamp(static_cast<double>((*planes[c])[i]), 0.0, 1.0);
      samples[3 * i + c] = static_cast<std::uint8_t>(std::lround(255.0 * srgbEncode(light)));
    }
  }
  return {linear.width, linear.height, 3, std::move(samples), {}, {}};
}

double overlap(const std::vector<float>& truth, const std::vector<std::uint8_t>& mask) {
  std::size_t both = 0, either = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const bool a = truth[i] > 0.5F, b = mask[i] > 127;
    both += a && b;
    either += a || b;
  }
  return either == 0 ? 1.0 : static_cast<double>(both) / static_cast<double>(either);
}

}  // namespace parhelion
