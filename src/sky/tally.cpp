// SPDX-License-Identifier: Apache-2.0
#include "sky/tally.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "sky/camera.h"

namespace parhelion {
namespace {

void requireValid(const TallyInfo& info, int colours) {
  static_cast<void>(Camera(info.camera));  // throws for settings that make no picture
  if (colours != 1 && colours != 3) throw std::invalid_argument("tally: colours must be 1 or 3");
  const bool whiteFits = info.white.x >= 0.0 && std::isfinite(info.white.x) && info.white.z >= 0.0 &&
                         std::isfinite(info.white.z) && info.white.y == 1.0;
  if (!whiteFits) throw std::invalid_argument("tally: the white must be finite XYZ with Y = 1");
}

/// The totals of two tallies together, or what is left of the first without the second.
template <class Combine>
void combineTotals(TallyInfo& info, const TallyInfo& other, const Combine& combine) {
  TallyInfo all = info;
  combine(all.intercepted, other.intercepted);
  combine(all.undeviated, other.undeviated);
  for (std::size_t i = 0; i < 3; ++i) combine(all.interceptedXyz[i], other.interceptedXyz[i]);
  info = std::move(all);
}

}  // namespace

Tally::Tally(TallyInfo tallyInfo, int colours)
    : info((requireValid(tallyInfo, colours), std::move(tallyInfo))),
      width_(info.camera.width),
      height_(info.camera.height),
      colours_(colours),
      stride_(colours == 1 ? 4 : 8),
      perWhite_(perWhiteOf(info.white)),
      lines_((static_cast<std::size_t>(pixels()) * stride_ + 7) / 8) {
  if (info.symmetry == TallySymmetry::radial) makeRings(info.toSun());
}

Vec3 Tally::xyz(int pixel) const {
  const double y = luminance(pixel);
  if (colours_ == 1) return y * info.white;
  return {fromFixed(raw(pixel, kX)) * info.white.x, y, fromFixed(raw(pixel, kZ)) * info.white.z};
}

double Tally::fullness() const { return std::max(lines_.fullness(), rings_ ? rings_->fullness() : 0.0); }

double Tally::luminanceError(int pixel) const {
  const std::uint64_t rays = info.rayCount();
  if (rays == 0) return 0.0;
  const double sum = luminance(pixel);
  return std::sqrt(std::max(0.0, squares(pixel) - sum * sum / static_cast<double>(rays)));
}

std::string Tally::objectionTo(const Tally& other) const {
  if (colours_ != other.colours_) return "one is in colour, the other is not";
  if (rings_.has_value() != other.rings_.has_value()) return "only one of them is in rings";
  return {};
}

RadialSky Tally::ringsWith(const Tally& other) const {
  RadialSky sum = *rings_;
  sum.merge(*other.rings_);
  if (!sum.fitsPixels()) {  // no pixel can be too full where all rings together are not
    Tally trial(info, colours_);
    sum.spreadOver(trial);
  }
  return sum;
}

void Tally::addSums(const Tally& other) {
  std::string objection = objectionTo(other);
  if (objection.empty()) objection = objectionToAdding(info, other.info);
  if (!objection.empty()) throw std::invalid_argument("tally: " + objection);
  TallyInfo sum = info;
  combineTotals(sum, other.info, [](auto& total, const auto& more) { total.merge(more); });
  sum.rays.insert(sum.rays.end(), other.info.rays.begin(), other.info.rays.end());
  sum.rays = joined(std::move(sum.rays));
  // From here on nothing throws once something has changed.
  if (rings_)
    rings_ = ringsWith(other);
  else
    addLines(lines_, other.lines_);
  info = std::move(sum);
}

void Tally::merge(const Tally& other) {
  addSums(other);
  if (rings_) spreadRings();
}

void Tally::subtract(const Tally& other) {
  subtractSums(other);
  if (rings_) spreadRings();
}

void Tally::addPlaces(const Tally& other) {
  if (const std::string objection = objectionTo(other); !objection.empty())
    throw std::invalid_argument("tally: " + objection);
  if (rings_)
    rings_ = ringsWith(other);
  else
    addLines(lines_, other.lines_);
}

void Tally::takeAsOne(const Tally& shared) {
  if (rings_) {
    for (int bin = 0; bin < rings_->bins(); ++bin) {
      rings_->setRaw(bin, kSquares, rings_->raw(bin, kSquares) + shared.rings_->raw(bin, kSquares));
      rings_->setRaw(bin, kHits, rings_->raw(bin, kHits) - shared.rings_->raw(bin, kHits));
    }
    return;
  }
  for (int pixel = 0; pixel < pixels(); ++pixel) {
    if (shared.isDark(pixel)) continue;
    setRaw(pixel, kSquares, raw(pixel, kSquares) + shared.raw(pixel, kSquares));
    setRaw(pixel, kHits, raw(pixel, kHits) - shared.raw(pixel, kHits));
  }
}

void Tally::subtractSums(const Tally& other) {
  std::string objection = objectionTo(other);
  TallyInfo rest = info;
  rest.rays = raysWithout(info.rays, other.info.rays);
  if (objection.empty()) objection = objectionToAdding(rest, other.info);
  if (objection.empty() && rest.rayCount() + other.info.rayCount() != info.rayCount())
    objection = wordsFor(raysWithout(other.info.rays, info.rays)) + " are not in it";
  if (!objection.empty()) throw std::invalid_argument("tally: " + objection);
  combineTotals(rest, other.info, [](auto& total, const auto& less) { total.subtract(less); });
  if (rings_)
    rings_->subtract(*other.rings_);
  else
    subtractLines(lines_, other.lines_);
  info = std::move(rest);
}

RadialSky& Tally::makeRings(const Vec3& toCentre) {
  if (rings_ && rings_->toCentre() != toCentre)
    throw std::invalid_argument("tally: its rings are about another centre");
  if (!rings_) rings_.emplace(info, toCentre, colours_);
  return *rings_;
}

void Tally::spreadRings() { rings_->spreadOver(*this); }

namespace {

/// In the middle column one deposit becomes, with its mirror image, one of twice the light.
int timesInMiddle(int slot) { return slot == Tally::kHits ? 1 : slot == Tally::kSquares ? 4 : 2; }

}  // namespace

void Tally::addMirrorImage() {
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; 2 * x < width_; ++x) {
      const int left = y * width_ + x, right = y * width_ + width_ - 1 - x;
      if (isDark(left) && isDark(right)) continue;
      std::int64_t *sums = &at(static_cast<std::size_t>(left) * stride_),
                   *mirrored = &at(static_cast<std::size_t>(right) * stride_);
      for (int slot = 0; slot < slots(); ++slot) {
        const std::int64_t one = sums[slot];
        if (left != right)
          addFixed(sums[slot], mirrored[slot]);
        else
          for (int times = timesInMiddle(slot); times > 1; --times) addFixed(sums[slot], one);
        mirrored[slot] = sums[slot];
      }
    }
  }
}

void Tally::removeMirrorImage() {
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; 2 * x < width_; ++x) {
      const int left = y * width_ + x, right = y * width_ + width_ - 1 - x;
      if (isDark(right)) continue;
      for (int slot = 0; slot < slots(); ++slot)
        setRaw(right, slot, left == right ? raw(left, slot) / timesInMiddle(slot) : 0);
    }
  }
}

bool Tally::operator==(const Tally& other) const {
  return colours_ == other.colours_ && info == other.info && lines_ == other.lines_ && rings_ == other.rings_;
}

}  // namespace parhelion
