// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "math/conventions.h"
#include "sky/fixed_point.h"
#include "sky/sum_line.h"
#include "sky/tally_info.h"

namespace parhelion {

class Tally;

/// The light of a sky that is the same all around one direction, its centre. It is summed in rings about the centre, as
/// exact integers like those of a Tally. When it is spread over a picture, each hit counts for its whole ring.
///
/// A ring is a step of the chord, the straight distance on the unit sphere. Up to 90 degrees from the centre the rings
/// are equal steps of the chord from the centre. Beyond, they are equal steps of the chord to the antipode. The solid
/// angle of a cap is pi chord^2, so nothing cancels near the centre or the antipode, and no ring costs an arc cosine.
class RadialSky {
 public:
  /// An empty sky about the unit world vector `toCentre`, for tallies of this info's white and this number of colours.
  ///
  /// Rings are at most an eighth as wide as the smallest step from a pixel to the next one away from the picture's
  /// centre (in a panorama: from a pixel to the next one in latitude). But there are at least 2^13 of them and at most
  /// 2^16. The latter are 0.0025 to 0.0035 degrees wide.
  ///
  /// Throws std::invalid_argument for colours other than 1 and 3.
  RadialSky(const TallyInfo& info, const Vec3& toCentre, int colours = 3);

  int bins() const { return static_cast<int>(rings_.size()); }

  /// Where the sky point toward a unit world vector lies among the rings, from 0 at the centre to bins() at the
  /// antipode.
  double place(const Vec3& toSky) const {
    const bool front = glm::dot(toSky, toCentre_) >= 0.0;
    const Vec3 chord = front ? toSky - toCentre_ : toSky + toCentre_;
    const double steps = glm::length(chord) * perChord_;
    return front ? steps : static_cast<double>(bins()) - steps;
  }

  int binAt(const Vec3& toSky) const { return std::min(static_cast<int>(place(toSky)), bins() - 1); }

  /// Solid angle (sr) of a ring.
  double solidAngle(int bin) const {
    return kPi / (perChord_ * perChord_) * (2.0 * std::min(bin, bins() - 1 - bin) + 1.0);
  }

  /// Adds the light (CIE XYZ) of one bundle to a ring; `firstHalf` is as in Tally::add(). Not for several threads at
  /// once: each thread has a sky of its own, and these are merged. Throws std::overflow_error, as merge() does, where a
  /// ring cannot hold the light.
  void add(int bin, const Vec3& xyz, bool firstHalf) { add(bin, toFixedLight(xyz, perWhite_), firstHalf); }
  void add(int bin, const FixedLight& light, bool firstHalf) {
    SumLine& ring = rings_[static_cast<std::size_t>(bin)];
    addFixed(ring.place[TallySlots::kY], light.y);
    addFixed(ring.place[TallySlots::kSquares], light.squared());
    ring.place[TallySlots::kHits] += 1;
    if (firstHalf) addFixed(ring.place[TallySlots::kFirstHalf], light.y);
    if (colours_ == 1) return;
    addFixed(ring.place[TallySlots::kX], light.x);
    addFixed(ring.place[TallySlots::kZ], light.z);
  }

  /// For rings that are those of SkyTally::Shared.
  void addShared(int bin, std::int64_t squares, std::int64_t hits) {
    SumLine& ring = rings_[static_cast<std::size_t>(bin)];
    addFixed(ring.place[TallySlots::kSquares], squares);
    addFixed(ring.place[TallySlots::kHits], hits);
  }

  /// Adds the light of another sky. Where it throws, it changes nothing: std::invalid_argument if centre, rings or
  /// colours differ, std::overflow_error where a ring cannot hold the light.
  void merge(const RadialSky& other);

  /// Takes out what merge() has added.
  void subtract(const RadialSky& other);

  /// How full one ring or pixel would be that held all of them.
  double fullnessOfAll() const;

  /// Whether all rings together hold less than fits into one pixel, so that no pixel can overflow.
  bool fitsPixels() const;

  const Vec3& toCentre() const { return toCentre_; }
  int slots() const { return colours_ == 1 ? 4 : 6; }

  /// The numbers of a ring, for files.
  std::int64_t raw(int bin, int slot) const {
    return rings_[static_cast<std::size_t>(bin)].place[static_cast<std::size_t>(slot)];
  }
  void setRaw(int bin, int slot, std::int64_t value) {
    rings_[static_cast<std::size_t>(bin)].place[static_cast<std::size_t>(slot)] = value;
  }

  /// All integers of all rings.
  std::span<std::int64_t> sums() { return integersOf(rings_); }

  bool operator==(const RadialSky&) const = default;

  /// How full the fullest ring is, from 0 to 1. At 1 nothing more fits into it.
  double fullness() const { return parhelion::fullness(rings_); }

  /// Takes all light away.
  void clear() { std::ranges::fill(rings_, SumLine{}); }

  /// Sets all pixels of a tally from the rings. The radiance is taken as constant across a ring.
  ///
  ///   - A pixel's light is the integral of the rings' radiance over the pixel's part of the sky.
  ///   - Its squares are those of the hits' shares in the pixel, so that luminanceError() is the pixel's own. They fall
  ///     short where a bundle hits several rings of one pixel (see Tally::add()).
  ///   - Its hits are the number of equal hits that have the same relative error.
  ///
  /// Pixels of the same ring share its noise.
  ///
  /// A pixel that is crossed by an edge of the profile is right to 1e-3 of the light it would hold in full. A pixel on
  /// the image circle is right to 4e-3 of a whole pixel, in an orthographic fisheye to 2e-2. A fisheye of the whole
  /// sphere squeezes the last degree before its circle into 1/32 of a pixel. What lies there is shared among the
  /// outermost pixels.
  ///
  /// Rounding to a tally's integers costs at most 2^-29 of a ray's light, which is 1e-6 of a pixel with 1/500 of a ray.
  /// Squares are coarser. In a pixel that holds the light of n rays and covers the share w of a ring, luminanceError()
  /// is off by less than 2^-28 / (n w) of itself.
  ///
  /// Throws std::invalid_argument if the colours differ.
  void spreadOver(Tally& tally) const;

  /// A sky, and the tally that it is to be spread over.
  struct Spreading {
    const RadialSky* sky;
    Tally* tally;
  };

  /// Does so with several skies that have the same rings, over tallies of the same camera: for little more than one
  /// takes, since all share the work of finding which rings a pixel lies in.
  static void spread(std::span<const Spreading> all);

  /// Whether no light is in any ring.
  bool isDark() const;

 private:
  /// Throws std::invalid_argument unless the rings of both are the same.
  void requireSameRings(const RadialSky& other) const;

  struct Densities;

  Vec3 toCentre_, perWhite_;
  int colours_;
  double perChord_;             // rings per chord length on the unit sphere
  std::vector<SumLine> rings_;  // by TallySlots::Slot
};

}  // namespace parhelion
