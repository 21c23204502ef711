// SPDX-License-Identifier: Apache-2.0
#include "render/ring_picture.h"

#include <algorithm>
#include <cmath>

#include "sky/radial_sky.h"
#include "sky/tally.h"

namespace parhelion {

namespace {

// Points of the sun's disc that rings are widened by: distances from its centre, and angles of half a turn about it.
constexpr int kDiscDistances = 12, kDiscAngles = 24;
// Rays whose light the tally of rings is given, for its whole numbers.
constexpr double kRays = 1e7;

}  // namespace

Rings widened(const Rings& rings, const Sun& sun) {
  if (sun.isPoint()) return rings;
  const SunDisc disc = sun.disc();
  const auto bins = static_cast<int>(rings.light.size());
  const double width = kPi / bins;
  Rings result{std::vector<Tristimulus>(rings.light.size()), std::vector<double>(rings.light.size())};
  for (int i = 0; i < kDiscDistances; ++i) {
    const double r = std::asin(disc.radius.at((i + 0.5) / kDiscDistances) * disc.sinRadius);
    const double sinR = std::sin(r), cosR = std::cos(r);
    for (int j = 0; j < kDiscAngles; ++j) {
      const double turn = std::cos((j + 0.5) * kPi / kDiscAngles), part = 1.0 / (kDiscDistances * kDiscAngles);
      for (int bin = 0; bin < bins; ++bin) {
        const double angle = (bin + 0.5) * width, s = std::sin(angle), c = std::cos(angle);
        const double onto = c * cosR - s * sinR * turn, across = s * cosR + c * sinR * turn,
                     rest = sinR * std::sqrt(1.0 - turn * turn);
        const double place = std::atan2(std::hypot(across, rest), onto) / width - 0.5;
        const double before = std::floor(place), t = place - before;
        for (const int step : {0, 1}) {
          const int to = std::clamp(static_cast<int>(before) + step, 0, bins - 1);
          const double share = part * (step ? t : 1.0 - t);
          const auto from = static_cast<std::size_t>(bin), into = static_cast<std::size_t>(to);
          for (std::size_t k = 0; k < 3; ++k) result.light[into][k] += share * rings.light[from][k];
          result.error[into] += share * rings.error[from];
        }
      }
    }
  }
  return result;
}

std::vector<Tristimulus> spread(const std::vector<Tristimulus>& rings, const TallyInfo& about, int colours) {
  TallyInfo info = about;
  info.rays = {{0, static_cast<std::uint64_t>(kRays)}};
  RadialSky radial(info, info.toSun(), colours);
  // Up to the edges of rings: light is even within each of those that it is given in.
  const auto bins = static_cast<double>(rings.size());
  std::vector<Tristimulus> light(rings.size() + 1);
  for (std::size_t k = 0; k < rings.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) light[k + 1][c] = light[k][c] + rings[k][c];
  const auto upTo = [&](double angle, const auto& value) {
    const double place = std::clamp(angle / kPi * bins, 0.0, bins);
    const auto cell = std::min(static_cast<std::size_t>(place), rings.size() - 1);
    const double t = place - static_cast<double>(cell);
    return (1.0 - t) * value(cell) + t * value(cell + 1);
  };
  const int count = radial.bins();
  const auto edge = [&](int ring) {
    const double chord = 2.0 * std::sqrt(2.0) * std::min(ring, count - ring) / count;
    const double angle = 2.0 * std::asin(0.5 * chord);
    return 2 * ring <= count ? angle : kPi - angle;
  };
  const Vec3& white = info.white;
  for (int ring = 0; ring < count; ++ring) {
    const double from = edge(ring), to = edge(ring + 1);
    const auto within = [&](const auto& value) { return upTo(to, value) - upTo(from, value); };
    const auto colour = [&](std::size_t c) { return kRays * within([&](std::size_t k) { return light[k][c]; }); };
    const double y = colour(1);
    radial.setRaw(ring, TallySlots::kY, toFixed(y));
    radial.setRaw(ring, TallySlots::kFirstHalf, toFixed(0.5 * y));
    radial.setRaw(ring, TallySlots::kHits, y > 0.0 ? 1 : 0);
    if (colours == 1) continue;
    radial.setRaw(ring, TallySlots::kX, toFixed(white.x > 0.0 ? colour(0) / white.x : 0.0));
    radial.setRaw(ring, TallySlots::kZ, toFixed(white.z > 0.0 ? colour(2) / white.z : 0.0));
  }
  Tally tally(info, colours);
  radial.spreadOver(tally);
  std::vector<Tristimulus> pixels;
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
    const Vec3 xyz = colours == 1 ? Vec3(tally.luminance(pixel)) : tally.xyz(pixel);
    pixels.push_back({xyz.x / kRays, xyz.y / kRays, xyz.z / kRays});
  }
  return pixels;
}

}  // namespace parhelion
