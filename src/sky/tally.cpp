// SPDX-License-Identifier: Apache-2.0
#include "sky/tally.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "sky/camera.h"

namespace parhelion {
namespace {

/// 1 / x for light that is there, 0 for light that is not.
double inverseOrZero(double x) { return x > 0.0 ? 1.0 / x : 0.0; }

void requireValid(const TallyInfo& info, int colours) {
  static_cast<void>(Camera(info.camera));  // throws for settings that make no picture
  if (colours != 1 && colours != 3) throw std::invalid_argument("tally: colours must be 1 or 3");
  const bool whiteFits = info.white.x >= 0.0 && std::isfinite(info.white.x) && info.white.z >= 0.0 &&
                         std::isfinite(info.white.z) && info.white.y == 1.0;
  if (!whiteFits) throw std::invalid_argument("tally: the white must be finite XYZ with Y = 1");
}

/// The part of the info in which tallies must agree to be of one and the same picture.
TallyInfo withoutSums(TallyInfo info) {
  info.rays.clear();
  info.intercepted = info.undeviated = 0;
  return info;
}

}  // namespace

std::uint64_t TallyInfo::rayCount() const {
  std::uint64_t sum = 0;
  for (const RayRange& range : rays) sum += range.count;
  return sum;
}

double TallyInfo::undeviatedFraction() const {
  return intercepted > 0 ? fromFixed(undeviated) / fromFixed(intercepted) : 0.0;
}

std::vector<RayRange> joined(std::vector<RayRange> ranges) {
  std::erase_if(ranges, [](const RayRange& r) { return r.count == 0; });
  std::ranges::sort(ranges, {}, &RayRange::first);
  std::vector<RayRange> result;
  for (const RayRange& range : ranges) {
    if (range.count > std::numeric_limits<std::uint64_t>::max() - range.first) {
      throw std::invalid_argument("tally: ray numbers beyond 2^64");
    }
    const std::uint64_t end = result.empty() ? 0 : result.back().first + result.back().count;
    if (range.first < end) throw std::invalid_argument("tally: the same rays are counted twice");
    if (!result.empty() && range.first == end) {
      result.back().count += range.count;
    } else {
      result.push_back(range);
    }
  }
  return result;
}

Tally::Tally(TallyInfo tallyInfo, int colours) : info(std::move(tallyInfo)), colours_(colours) {
  requireValid(info, colours);
  width_ = info.camera.width;
  height_ = info.camera.height;
  stride_ = colours == 1 ? 4 : 8;
  perWhite_ = {inverseOrZero(info.white.x), 1.0, inverseOrZero(info.white.z)};
  lines_.resize((static_cast<std::size_t>(pixels()) * stride_ + 7) / 8);
}

Vec3 Tally::xyz(int pixel) const {
  const double y = luminance(pixel);
  if (colours_ == 1) return y * info.white;
  return {fromFixed(raw(pixel, kX)) * info.white.x, y, fromFixed(raw(pixel, kZ)) * info.white.z};
}

double Tally::luminanceError(int pixel) const {
  const std::uint64_t rays = info.rayCount();
  if (rays == 0) return 0.0;
  const double sum = luminance(pixel);
  return std::sqrt(std::max(0.0, squares(pixel) - sum * sum / static_cast<double>(rays)));
}

void Tally::merge(const Tally& other) {
  if (colours_ != other.colours_) throw std::invalid_argument("tally: one is in colour, the other is not");
  if (withoutSums(info) != withoutSums(other.info)) {
    throw std::invalid_argument("tally: scene, seed, camera or program version differ");
  }
  std::vector<RayRange> all = info.rays;
  all.insert(all.end(), other.info.rays.begin(), other.info.rays.end());
  info.rays = joined(std::move(all));
  addFixed(info.intercepted, other.info.intercepted);
  addFixed(info.undeviated, other.info.undeviated);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    for (std::size_t k = 0; k < 8; ++k) addFixed(lines_[i].place[k], other.lines_[i].place[k]);
  }
}

namespace {

/// In the middle column one deposit becomes, with its mirror image, one of twice the light.
int timesInMiddle(int slot) { return slot == Tally::kHits ? 1 : slot == Tally::kSquares ? 4 : 2; }

}  // namespace

void Tally::addMirrorImage() {
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; 2 * x < width_; ++x) {
      const int left = y * width_ + x, right = y * width_ + width_ - 1 - x;
      for (int slot = 0; slot < slots(); ++slot) {
        const int images = left != right ? 2 : timesInMiddle(slot);
        std::int64_t sum = 0;
        for (int i = 0; i < images; ++i) addFixed(sum, raw(i == 0 ? left : right, slot));
        setRaw(left, slot, sum);
        setRaw(right, slot, sum);
      }
    }
  }
}

void Tally::removeMirrorImage() {
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; 2 * x < width_; ++x) {
      const int left = y * width_ + x, right = y * width_ + width_ - 1 - x;
      for (int slot = 0; slot < slots(); ++slot)
        setRaw(right, slot, left == right ? raw(left, slot) / timesInMiddle(slot) : 0);
    }
  }
}

bool Tally::operator==(const Tally& other) const {
  return colours_ == other.colours_ && info == other.info && lines_ == other.lines_;
}

}  // namespace parhelion
