// SPDX-License-Identifier: Apache-2.0
#include "photo/sky_choice.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace parhelion {

namespace {

constexpr double kSmallestArea = 0.02;  // of the picture
constexpr double kThinWeight = 2.0;     // thin lines cost more than their area
constexpr double kLarger = 1.02;        // times the area of another region: larger than by a few pixels on its border
constexpr double kSmaller = 0.95;       // times that area: smaller than by these
constexpr float kThinSteps = 4.0F;      // a line's least difference from both of its sides

// The difference across a border, over two pixels on each side where the first is perhaps a mixture.
struct BorderSum {
  double count = 0.0, clear = 0.0, length = 0.0;
  std::array<double, 3> change{};

  void add(const SkyScene& scene, int x, int y, int dx, int dy) {
    const auto& colours = scene.colours;
    const Opponent &in0 = colours.nearest(x - dx, y - dy), &in1 = colours.at(x, y);
    const Opponent &out0 = colours.at(x + dx, y + dy), &out1 = colours.nearest(x + 2 * dx, y + 2 * dy);
    double square = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double difference = 0.5 * static_cast<double>(out0[c] + out1[c] - in0[c] - in1[c]);
      change[c] += difference;
      square += difference * difference;
    }
    const double steps2 = square / (2.0 * static_cast<double>(scene.step * scene.step));
    clear += steps2 / (1.0 + steps2);
    length += std::sqrt(square);
    count += 1.0;
  }
  double clearness() const { return count > 0.0 ? clear / count : 0.0; }
  double brightening() const { return count > 0.0 ? change[0] / count : 0.0; }
  /// 1 if the colour changes everywhere in the same way.
  double consistency() const {
    const double sum2 = change[0] * change[0] + change[1] * change[1] + change[2] * change[2];
    return length > 0.0 ? std::sqrt(sum2) / length : 0.0;
  }
};

template <class F>
void eachBorder(const Region& sky, const F& f) {
  constexpr std::array<std::array<int, 2>, 4> kWays{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
  for (int y = 0; y < sky.height(); ++y) {
    for (int x = 0; x < sky.width(); ++x) {
      if (sky.at(x, y) == 0) continue;
      for (const auto& [dx, dy] : kWays) {
        if (sky.inside(x + dx, y + dy) && sky.at(x + dx, y + dy) == 0) f(x, y, dx, dy);
      }
    }
  }
}

// Pixels at the border may be mixtures and tell nothing about either side's colours.
bool atBorder(const Region& sky, int x, int y) {
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (sky.nearest(x + dx, y + dy) != sky.at(x, y)) return true;
    }
  }
  return false;
}

// Whether the pixel is much darker than what is on both sides of it, along any of four directions.
bool onThinLine(const SkyScene& scene, int x, int y) {
  constexpr std::array<std::array<int, 2>, 4> kWays{{{3, 0}, {0, 3}, {2, 2}, {2, -2}}};
  const auto& colours = scene.colours;
  return std::any_of(kWays.begin(), kWays.end(), [&](const auto& way) {
    const auto [dx, dy] = way;
    if (!colours.inside(x - dx, y - dy) || !colours.inside(x + dx, y + dy)) return false;
    const float beside = std::min(colours.at(x - dx, y - dy)[0], colours.at(x + dx, y + dy)[0]);
    return beside - colours.at(x, y)[0] > kThinSteps * scene.step;
  });
}

// What sets a region apart from the rest of a larger one.
struct Division {
  BorderSum border;
  double separation = 0.0;
  double brightening = 0.0;  // mean lightness of the rest less that of the region
  bool nested = false;
};

constexpr double kOutside = 0.02;  // of a region may lie outside the one that contains it

Division divide(const SkyScene& scene, const Region& inner, const Region& outer) {
  Division division;
  ColourHistogram inside, rest;
  double innerCount = 0.0, outsideCount = 0.0, restCount = 0.0, innerLight = 0.0, restLight = 0.0;
  for (int y = 0; y < inner.height(); ++y) {
    for (int x = 0; x < inner.width(); ++x) {
      const bool in = inner.at(x, y) != 0, out = outer.at(x, y) != 0;
      const auto light = static_cast<double>(scene.colours.at(x, y)[0]);
      innerCount += in;
      innerLight += in ? light : 0.0;
      restCount += out && !in;
      restLight += out && !in ? light : 0.0;
      outsideCount += in && !out;
      if ((in || out) && !atBorder(inner, x, y)) (in ? inside : rest).add(scene.colours.at(x, y));
    }
  }
  eachBorder(inner, [&](int x, int y, int dx, int dy) {
    if (outer.at(x + dx, y + dy) != 0) division.border.add(scene, x, y, dx, dy);
  });
  division.separation = ColourHistogram::separation(inside, rest);
  if (innerCount > 0.0 && restCount > 0.0) division.brightening = restLight / restCount - innerLight / innerCount;
  division.nested = outsideCount <= kOutside * innerCount;
  return division;
}

// Found on painted and real landscapes. A region must be nearly as good as the best to be chosen instead of it.
constexpr double kNearlyAsGood = 0.85;   // of a larger one
constexpr double kSmallerAsGood = 0.88;  // of a smaller one
constexpr double kLeastFront = 0.4;      // widths of the picture that land set apart borders on the sky
constexpr double kNoEdge = 0.7;          // clearness below which a border has gaps
constexpr double kApart = 0.58;          // clearness x separation x consistency of land below the sky
constexpr double kBrighterApart = 0.87;  // the same where it is brighter than the sky, as land rarely is
constexpr double kSurelyApart = 0.93;    // clearness x separation where consistency does not matter
constexpr double kBrighterSteps = 3.0;   // sky gets brighter toward the horizon, too
constexpr double kGlowSteps = 8.0;       // land that is brighter than the sky by more is sky with a glow

bool setApart(const SkyScene& scene, const Division& division) {
  const auto step = static_cast<double>(scene.step);
  const bool brighter = division.border.brightening() > step || division.brightening > kBrighterSteps * step;
  const double apart = division.border.clearness() * division.separation;
  const double consistent = apart * division.border.consistency();
  const bool front = division.border.count > kLeastFront * scene.colours.width();
  const bool apartEnough = brighter ? consistent > kBrighterApart : consistent > kApart || apart > kSurelyApart;
  return division.nested && front && division.brightening < kGlowSteps * step && apartEnough;
}

bool noEdgeBetween(const Division& division) {
  return division.nested && division.border.count > 0.0 && division.border.clearness() < kNoEdge;
}

}  // namespace

double SkyMerit::value() const {
  return area < kSmallestArea ? 0.0 : edge * separation * std::max(0.0, 1.0 - kThinWeight * thin);
}

SkyMerit skyMerit(const SkyScene& scene, const Region& sky) {
  ColourHistogram ofSky, ofLand;
  double count = 0.0, thin = 0.0;
  for (int y = 0; y < sky.height(); ++y) {
    for (int x = 0; x < sky.width(); ++x) {
      const bool in = sky.at(x, y) != 0;
      count += in;
      thin += in && onThinLine(scene, x, y);
      if (!atBorder(sky, x, y)) (in ? ofSky : ofLand).add(scene.colours.at(x, y));
    }
  }
  BorderSum border;
  eachBorder(sky, [&](int x, int y, int dx, int dy) { border.add(scene, x, y, dx, dy); });
  return {count / static_cast<double>(sky.size()), border.clearness(), ColourHistogram::separation(ofSky, ofLand),
          count > 0.0 ? thin / count : 0.0};
}

std::size_t chooseSky(const SkyScene& scene, const std::vector<Region>& regions, const std::vector<SkyMerit>& merits) {
  const auto value = [&](std::size_t i) { return merits[i].value(); };
  std::size_t best = 0;
  for (std::size_t i = 1; i < regions.size(); ++i) best = value(i) > value(best) ? i : best;
  const double top = value(best);
  // Moves to the best region that `better` prefers, until there is none; areas only grow or only shrink.
  const auto move = [&](double enough, const auto& better) {
    for (bool moved = true; moved;) {
      std::size_t next = best;
      for (std::size_t i = 0; i < regions.size(); ++i) {
        if (value(i) < enough * top || (next != best && value(i) <= value(next))) continue;
        if (better(i)) next = i;
      }
      moved = next != best;
      best = next;
    }
  };
  move(kNearlyAsGood, [&](std::size_t i) {
    return merits[i].area > kLarger * merits[best].area && noEdgeBetween(divide(scene, regions[best], regions[i]));
  });
  move(kSmallerAsGood, [&](std::size_t i) {
    return merits[i].area < kSmaller * merits[best].area && setApart(scene, divide(scene, regions[i], regions[best]));
  });
  return best;
}

}  // namespace parhelion
