// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace parhelion {

/// Where light that flies through a slab is drawn to be scattered, as an optical depth from where it starts.
///
/// Not in proportion to what is scattered there alone: some places are drawn in proportion to 1 over the depth between
/// them and the slab's faces, ahead and behind. For what leaves along the horizon comes from close to a face, and where
/// few walks get there each of them would have to bring a lot. Weights make up for it. Flights along the slab stay near
/// where they start, and are drawn as light is scattered.
class FlightPlaces {
 public:
  /// Whether light that leaves by the face ahead, and by the one behind, is wanted.
  struct Faces {
    bool ahead = true, behind = true;
  };

  /// Of a flight that leaves the slab after `depth`, and starts `behind` from where it would have entered it.
  FlightPlaces(double depth, double behind, Faces wanted);

  /// For a number in (0, 1): a depth within the slab.
  double at(double u) const;

  /// What is scattered from one depth to another over the chance that the place is drawn there, and the limit of that
  /// for both the same.
  double weight(double from, double to) const;
  double weightAt(double place) const;

  bool isGuided() const { return ahead_ + toBehind_ > 0.0; }

 private:
  double over(double scattered, double byAhead, double byBehind) const;

  double depth_, behind_, taken_;
  double ahead_ = 0.0, toBehind_ = 0.0;      // shares of places drawn by the faces
  double least_;                             // depth from a face up to which all places are drawn alike
  double logAhead_ = 0.0, logBehind_ = 0.0;  // logarithms of the ranges of distances from the faces
};

/// The share of 1 that a way of some optical depth takes, 1 - exp(-depth), without losing digits of small ones.
double takenOver(double depth);

}  // namespace parhelion
