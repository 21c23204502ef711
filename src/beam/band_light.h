// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "beam/cosine_table.h"
#include "beam/light_segments.h"
#include "beam/light_table.h"
#include "beam/ring_film.h"
#include "beam/sheet_totals.h"
#include "beam/tristimulus.h"

namespace parhelion {

/// How finely orientations and the sky about the sun are cut up.
struct BandMesh {
  int bands = 0;           // of the angle between c and the sun, over a quarter turn
  int rings = 0;           // of the sky about the sun, over half a turn
  int cells = 0;           // along each ring, over half a turn
  int first = 0, end = 0;  // rings that matter
  double orders = 0.0;     // waves around a ring that matter, at most

  bool operator==(const BandMesh&) const = default;

  /// Whether it has all rings and orders of another one, and is the same but for these.
  bool covers(const BandMesh& other) const {
    return first <= other.first && end >= other.end && orders >= other.orders &&
           BandMesh{bands, rings, cells, other.first, other.end, other.orders} == other;
  }
};

/// Where the cosines of rings lie in memory, ring after ring: those of a channel by parity, channel after channel.
class RingLayout {
 public:
  RingLayout(const BandMesh& mesh, const CosineTable& cosines, int channels);

  /// Orders of each parity that a ring has.
  int room(int ring) const { return rooms_[static_cast<std::size_t>(ring)]; }
  /// Where its numbers begin.
  std::size_t placeOf(int ring) const { return places_[static_cast<std::size_t>(ring)]; }
  std::size_t size() const { return places_.back(); }

 private:
  std::vector<int> rooms_;
  std::vector<std::size_t> places_;
};

/// What crystals do to light by the angle alpha between their c axes and the sun, all rolls alike.
///
/// Turning a crystal about the light turns its light around the sun, no more. So all that a band of alpha does is told
/// by the sky about the sun for one azimuth of c about it; any distribution of these azimuths is a convolution along
/// the rings. It is kept by cosines of the azimuth, where convolutions are products.
class BandLight {
 public:
  /// Colours: X, Y, Z, and Y of a coarse mesh. Grey: the last and Y alone. The tables must outlive this; that of light
  /// must be prepared for the bands that are asked for.
  BandLight(const LightTable& table, const CosineTable& cosines, const BandMesh& mesh, bool colours,
            const LightSegments& lights, const LightSegments& fewLights);
  ~BandLight();

  const BandMesh& mesh() const { return mesh_; }
  int channels() const { return colours_ ? 4 : 2; }

  const RingLayout& layout() const { return layout_; }

  /// Of one band, for crystals whose probability is 1.
  struct Band {
    AlignedVector<float> light;  // by ring
    std::vector<bool> lit;       // rings
    SheetTotals totals;          // of the mean light
  };

  /// Makes bands in parallel: the first of these are those of the numbers.
  void make(std::span<const int> numbers, std::vector<Band>& to);

 private:
  struct Scratch;
  template <int C>
  struct Room;
  using Four = Lanes<4>::Real;
  struct Row {
    bool dark = true;
    std::vector<double> light, density, excess, place, turn;  // place among the rings; azimuth about the sun, in cells
  };
  template <int C>
  void make(int band, std::unique_ptr<Scratch>& scratch, Band& to) const;
  void clear(Band& band) const;
  void see(double alpha, double index, const std::vector<double>& parts, int number, int stride, Row& row) const;
  /// A class of light in a band: what it does to light of each index at both ends of the band.
  struct Ends {
    int number;
    double alphaA, alphaB;
    std::vector<Row> a, b;
  };
  template <int C>
  void addSegment(const Ends& ends, const LightSegments& lights, const LightSegments::Segment& segment, int step,
                  RingFilm<C>& film) const;
  RingCorner exitAt(RingCorner corner, double index, int number) const;
  template <int C>
  void analyse(RingFilm<C>& film, Band& to) const;

  const LightTable& table_;
  const CosineTable& cosines_;
  BandMesh mesh_;
  bool colours_;
  LightSegments lights_, fewLights_;
  RingLayout layout_;
  std::vector<std::unique_ptr<Scratch>> scratch_;  // for pieces of work
};

}  // namespace parhelion
