// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "math/conventions.h"
#include "sky/fixed_point.h"
#include "sky/radial_sky.h"
#include "sky/sum_lines.h"
#include "sky/tally_info.h"

namespace parhelion {

/// What each pixel of the camera received, as exact integers. It is the contract between tracing and reconstruction.
/// The unit of light is what a ray brings on average.
///
/// Of a radial sky it also keeps the rings, and its pixels are what the rings spread over them. So tallies of some rays
/// each have the same sum as one of all the rays, to the bit.
class Tally : public TallySlots {
 public:
  TallyInfo info;  // camera and white stay as they were constructed; the rest is the tracer's to fill in

  /// An empty tally, with the rings about the sun if its symmetry is radial. `colours` is 3 (CIE XYZ) or 1 (luminance
  /// only, for monochromatic light). Throws std::invalid_argument for other numbers, a camera out of range, or a white
  /// that is negative, not finite or has Y other than 1.
  explicit Tally(TallyInfo tallyInfo, int colours = 3);

  int width() const { return width_; }
  int height() const { return height_; }
  int colours() const { return colours_; }
  int pixels() const { return width_ * height_; }

  /// 1 over the white's XYZ, 0 where it has none: X and Z are stored relative to it.
  const Vec3& perWhite() const { return perWhite_; }

  /// Adds the light (CIE XYZ) of one bundle of rays to a pixel, given by its row-major index. Safe to call from any
  /// number of threads at once.
  ///
  /// `firstHalf` is true for bundles of even number. The two halves are independent estimates of the same picture.
  ///
  /// A bundle may bring light to one pixel more than once. That light should be summed before and added once, else the
  /// sum of squares is too small.
  ///
  /// Throws std::overflow_error where the pixel cannot hold it.
  void add(int pixel, const Vec3& xyz, bool firstHalf) {
    deposit(pixel, toFixedLight(xyz, perWhite_), firstHalf, [](std::int64_t& sum, std::int64_t amount) {
      std::int64_t before = std::atomic_ref<std::int64_t>(sum).fetch_add(amount, std::memory_order_relaxed);
      addFixed(before, amount);
    });
  }

  /// Does the same, several times faster. The caller must see to it that nobody else adds to the pixel at the same
  /// time.
  void addExclusively(int pixel, const Vec3& xyz, bool firstHalf) {
    addExclusively(pixel, toFixedLight(xyz, perWhite_), firstHalf);
  }
  void addExclusively(int pixel, const FixedLight& light, bool firstHalf) {
    deposit(pixel, light, firstHalf, addFixed);
  }

  /// For a tally that is SkyTally::Shared.
  void addShared(int pixel, std::int64_t squares, std::int64_t hits) {
    std::int64_t* sums = &at(static_cast<std::size_t>(pixel) * stride_);
    addFixed(sums[kSquares], squares);
    addFixed(sums[kHits], hits);
  }

  /// Tells the processor to fetch a pixel into the cache, because light will be added to it soon.
  void prefetch(int pixel) const { __builtin_prefetch(&at(static_cast<std::size_t>(pixel) * stride_), 1); }

  /// The light of a pixel in CIE XYZ. With one colour it is the luminance in the sun's white.
  Vec3 xyz(int pixel) const;

  /// Sums of a pixel: the luminance of all bundles, that of the bundles of even number, and the square of the luminance
  /// that each bundle brought.
  double luminance(int pixel) const { return fromFixed(raw(pixel, kY)); }
  double firstHalf(int pixel) const { return fromFixed(raw(pixel, kFirstHalf)); }
  double squares(int pixel) const { return fromFixed(raw(pixel, kSquares), kSquareScale); }

  /// How many times light was added to a pixel.
  std::int64_t hits(int pixel) const { return raw(pixel, kHits); }

  /// All integers of all pixels.
  std::span<std::int64_t> sums() { return integersOf(lines_.all()); }

  /// Sets them to 0.
  void clearPixels() { lines_.clear(); }

  /// Whether nobody has ever written to any pixel, or to one and those next to it. What was written may be 0.
  bool isBlank() const { return lines_.isBlank(); }
  bool isBlank(int pixel) const { return lines_.isBlank(static_cast<std::size_t>(pixel) * stride_ / 8); }

  /// How full the fullest of all sums is, those of rings included, from 0 to 1. At 1 nothing more fits into it.
  double fullness() const;

  /// The standard error of luminance(pixel). Divided by the intercepted light and the solid angle, it is the standard
  /// error of the radiance.
  double luminanceError(int pixel) const;

  /// Adds the rays of another tally of the same scene. Gaps between the ranges of rays are allowed. Where it throws, it
  /// changes nothing: std::invalid_argument with objectionToAdding() or for other colours or rings, std::overflow_error
  /// where one of the two is too full for the other.
  void merge(const Tally& other);

  /// Does the same, but leaves the pixels of a radial sky as they were until the next spreadRings(): that takes a while
  /// and is needed once only, however many tallies are added.
  void addSums(const Tally& other);

  /// Takes out what merge() has added, so that what is left is the same to the bit as if it had never been there.
  /// Throws std::invalid_argument, and changes nothing, unless all rays of `other` are in it and both are of the same
  /// scene.
  void subtract(const Tally& other);

  /// Does the same, but leaves the pixels of a radial sky as they were, as addSums() does.
  void subtractSums(const Tally& other);

  /// Adds the places of another tally of the same rays, all but the totals and the rays: for `sums` of what is told
  /// apart. Hits and squares are added as they are. Throws std::overflow_error where one does not fit.
  void addPlaces(const Tally& other);

  /// Makes one deposit of several, as `shared` says; see SkyTally::Shared.
  void takeAsOne(const Tally& shared);

  bool operator==(const Tally& other) const;

  /// Adds to every pixel what its mirror image, left for right, holds. Each ray then counts for two. If the width is
  /// odd, both land in the same pixel of the middle column. Throws std::overflow_error where a pixel cannot hold it.
  void addMirrorImage();

  /// For a tally after addMirrorImage(): takes away what is right of the middle and half of the middle's light, so that
  /// addMirrorImage() makes the same again.
  void removeMirrorImage();

  /// The rings of a sky that is the same all around the unit world vector `toCentre`. They are made if they are not
  /// there. Throws std::invalid_argument if these are about another centre.
  RadialSky& makeRings(const Vec3& toCentre);

  /// The rings of a radial sky, or null.
  const RadialSky* rings() const { return rings_ ? &*rings_ : nullptr; }

  /// Sets all pixels of a radial sky from its rings. Throws std::overflow_error where a pixel cannot hold its light.
  void spreadRings();

  /// The numbers of a pixel, for files.
  int slots() const { return colours_ == 1 ? 4 : 6; }
  std::int64_t raw(int pixel, int slot) const {
    return at(static_cast<std::size_t>(pixel) * stride_ + static_cast<std::size_t>(slot));
  }

  /// Whether all of them are 0.
  bool isDark(int pixel) const {
    if (isBlank(pixel)) return true;
    std::int64_t bits = 0;
    for (int slot = 0; slot < slots(); ++slot) bits |= raw(pixel, slot);
    return bits == 0;
  }

  void setRaw(int pixel, int slot, std::int64_t value) {
    at(static_cast<std::size_t>(pixel) * stride_ + static_cast<std::size_t>(slot)) = value;
  }
  void setRaw(int pixel, const SumLine& sums) {
    if (sums == SumLine{} && isDark(pixel)) return;
    std::copy_n(sums.place.begin(), slots(), &at(static_cast<std::size_t>(pixel) * stride_));
  }

 private:
  /// Why nothing of another tally can be added or taken out; empty if it can.
  std::string objectionTo(const Tally& other) const;

  /// The rings of both together. Throws std::overflow_error where they do not fit, into pixels neither.
  RadialSky ringsWith(const Tally& other) const;

  std::int64_t& at(std::size_t i) { return lines_[i / 8].place[i % 8]; }
  const std::int64_t& at(std::size_t i) const { return lines_[i / 8].place[i % 8]; }

  template <class AddTo>
  void deposit(int pixel, const FixedLight& light, bool firstHalf, AddTo addTo) {
    std::int64_t* sums = &at(static_cast<std::size_t>(pixel) * stride_);
    addTo(sums[kY], light.y);
    addTo(sums[kSquares], light.squared());
    addTo(sums[kHits], 1);
    if (firstHalf) addTo(sums[kFirstHalf], light.y);
    if (colours_ == 1) return;
    addTo(sums[kX], light.x);
    addTo(sums[kZ], light.z);
  }

  int width_, height_, colours_;
  std::size_t stride_;
  Vec3 perWhite_;   // 1 / white, 0 where the white has none
  SumLines lines_;  // a pixel has 8 integers (colour) or 4 (luminance only), so that one line holds them
  std::optional<RadialSky> rings_;
};

}  // namespace parhelion
