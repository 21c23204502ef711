// SPDX-License-Identifier: Apache-2.0
#include "sky/tally_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace parhelion {
namespace {

using Line = std::array<double, 6>;  // by slot, in light; exact below 2^53 units, rounded above

// Relative; the energies of a ray's exits add up to what came in but for the rounding of some thousand of them, and
// sums above 2^53 units lose their last bits here.
constexpr double kRounding = 1e-9;

// The rings' light over the pixels of a picture is off by less than this at the rim of the sky (sky/radial_sky.h).
constexpr double kOffAtRim = 0.05;

// Rays in a bundle at the most, and how far their light is from 1 on average: with Sobol' points they weigh what their
// crystals intercept.
constexpr double kMostInBundle = 4096.0, kMostPerRay = 8.0;

std::string words(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", x);
  return text;
}

[[noreturn]] void reject(const std::string& what, const std::string& should) {
  throw std::invalid_argument("damaged, or not of a run: " + what + ", and should be " + should);
}

/// The rules for the sums of one place, and of all together.
class SumRules {
 public:
  /// `spread`: the places are pixels over which `ringHits` hits of rings have been spread.
  SumRules(const TallyInfo& info, int slots, bool spread, double ringHits)
      : slots_(slots),
        spread_(spread),
        images_(info.images()),
        mostHits_(spread ? ringHits : images_ * static_cast<double>(info.rayCount())),
        most_{info.interceptedXyz[1].value(), 0.0, 0.0, 0.0, info.interceptedXyz[0].value(),
              info.interceptedXyz[2].value()},
        raysRounding_(images_ * static_cast<double>(info.rayCount()) / kWeightScale) {}

  void add(const Line& sums, const auto& place) {
    for (int slot = 0; slot < slots_; ++slot) {
      if (sums[slot] < 0.0) reject(nameOf(slot) + place() + words(sums[slot]), "0 or more");
      all_[slot] += sums[slot];
    }
    if (sums[TallySlots::kFirstHalf] > sums[TallySlots::kY])
      reject(nameOf(TallySlots::kFirstHalf) + place() + words(sums[TallySlots::kFirstHalf]),
             "at most the whole, " + words(sums[TallySlots::kY]));
    requireHits(sums, place);
    if (!spread_) requireSquares(sums, place);
    requireIntercepted(sums, place);
  }

  /// After the last place.
  void finish(const std::string& places) const {
    requireIntercepted(all_, [&] { return " of all " + places + " together is "; });
  }

 private:
  using Slot = TallySlots::Slot;

  static std::string nameOf(int slot) {
    constexpr std::array kNames{
        "the light", "the first half's light", "the sum of squares", "the number of hits", "the X", "the Z"};
    return kNames[static_cast<std::size_t>(slot)];
  }

  void requireHits(const Line& sums, const auto& place) const {
    const double hits = sums[Slot::kHits];
    if (hits > mostHits_)
      reject(nameOf(Slot::kHits) + place() + words(hits), "at most " + words(mostHits_) + ", as many as there are");
    for (int slot = 0; slot < slots_; ++slot)
      if (hits == 0.0 && sums[slot] > 0.0)
        reject(nameOf(slot) + place() + words(sums[slot]), "0 where there is no hit");
  }

  /// Of n numbers that are not negative the sum of squares S and the sum Y have S <= Y^2 <= n S.
  void requireSquares(const Line& sums, const auto& place) const {
    const double hits = sums[Slot::kHits], squares = sums[Slot::kSquares], light = sums[Slot::kY];
    // A deposit's light and square are rounded by half a unit; where it became its own mirror image, by 1 and 2. The
    // light is that of several exits, each rounded.
    constexpr double kExits = 16.0;
    const double off = hits * images_ * 0.5 * kExits / kWeightScale,
                 offSquares = hits * images_ * images_ * 0.5 / kSquareScale;
    const double most = (light + off) * (light + off) + offSquares;
    const double least = std::pow(std::max(0.0, light - off), 2) / std::max(1.0, hits) - offSquares;
    if (squares > most * (1.0 + kRounding))
      reject(nameOf(Slot::kSquares) + place() + words(squares), "at most the squared light, " + words(most));
    if (squares < least * (1.0 - kRounding))
      reject(nameOf(Slot::kSquares) + place() + words(squares),
             "at least the squared light over the hits, " + words(least));
  }

  void requireIntercepted(const Line& sums, const auto& place) const {
    const double factor = spread_ ? 1.0 + kOffAtRim : 1.0 + kRounding;
    const double slack = raysRounding_ + (sums[Slot::kHits] + 1.0) / kWeightScale;
    for (const int slot : {Slot::kY, Slot::kX, Slot::kZ})
      if (slot < slots_ && sums[slot] > most_[slot] * factor + slack)
        reject(nameOf(slot) + place() + words(sums[slot]),
               "at most what the crystals have intercepted, " + words(most_[slot]));
  }

  int slots_;
  bool spread_;
  double images_, mostHits_;
  Line most_;
  double raysRounding_;  // of all rays' intercepted light
  Line all_{};
};

/// `raw(slot)` are the stored integers.
Line lineOf(int slots, const auto& raw) {
  Line line{};
  for (int slot = 0; slot < slots; ++slot)
    line[slot] = slot == TallySlots::kHits
                     ? static_cast<double>(raw(slot))
                     : fromFixed(raw(slot), slot == TallySlots::kSquares ? kSquareScale : kWeightScale);
  return line;
}

/// Returns how many hits all rings hold.
double requirePlausibleRings(const Tally& tally, const RadialSky& rings) {
  SumRules rules(tally.info, rings.slots(), false, 0.0);
  double hits = 0.0;
  for (int bin = 0; bin < rings.bins(); ++bin) {
    const Line line = lineOf(rings.slots(), [&](int slot) { return rings.raw(bin, slot); });
    rules.add(line, [bin] { return " of ring " + std::to_string(bin) + " is "; });
    hits += line[TallySlots::kHits];
  }
  rules.finish("rings");
  return hits;
}

void requirePlausiblePixels(const Tally& tally, double ringHits) {
  SumRules rules(tally.info, tally.slots(), tally.rings() != nullptr, ringHits);
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
    const Line line = lineOf(tally.slots(), [&](int slot) { return tally.raw(pixel, slot); });
    rules.add(line, [&] {
      return " of the pixel in column " + std::to_string(pixel % tally.width()) + ", row " +
             std::to_string(pixel / tally.width()) + " is ";
    });
  }
  rules.finish("pixels");
}

void requirePlausibleTotals(const TallyInfo& info) {
  const double all = info.intercepted.value(), luminance = info.interceptedXyz[1].value();
  if (info.undeviated.units() > info.intercepted.units())
    reject("the undeviated light is " + words(info.undeviated.value()), "at most the intercepted, " + words(all));
  const auto rays = static_cast<double>(info.rayCount()), images = static_cast<double>(info.images());
  const double most = images * kMostPerRay * (rays > 0.0 ? rays + kMostInBundle : 0.0);
  const double least = images * std::max(0.0, rays - kMostInBundle) / kMostPerRay;
  for (const double light : {all, luminance}) {
    if (light > most || light < least || (light == 0.0) != (all == 0.0))
      reject("the light intercepted by " + words(rays) + " rays is " + words(light),
             rays > 0.0 ? "about " + words(images * rays) : "0");
  }
}

template <class Raw>
void requireShared(int places, const Raw& raw) {
  for (int place = 0; place < places; ++place)
    if (raw(place, TallySlots::kSquares) < 0 || raw(place, TallySlots::kHits) < 0)
      reject("what layers share at place " + std::to_string(place) + " is below 0", "0 or more");
}

}  // namespace

void requirePlausibleShared(const Tally& shared) {
  requireShared(shared.pixels(), [&](int pixel, int slot) { return shared.raw(pixel, slot); });
  if (shared.rings())
    requireShared(shared.rings()->bins(), [&](int bin, int slot) { return shared.rings()->raw(bin, slot); });
}

void requirePlausible(const Tally& tally) {
  requirePlausibleTotals(tally.info);
  const double ringHits = tally.rings() ? requirePlausibleRings(tally, *tally.rings()) : 0.0;
  requirePlausiblePixels(tally, ringHits);
}

}  // namespace parhelion
