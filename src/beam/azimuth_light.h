// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "beam/light_row.h"
#include "math/rotation_columns.h"

namespace parhelion {

/// What becomes of the light of a few elevations of the sun in crystals that stand alike but for their azimuths. Those
/// are traced at even steps of a turn, which come in pieces; this has some of them.
class AzimuthLight {
 public:
  /// Cells of a piece, and numbers that its nodes take.
  static constexpr int kPiece = 60;
  static constexpr std::size_t kRoom = 64;

  /// `rest` turns the crystal to the world at azimuth 0. Azimuths are those from 0 to `turn` (rad), in so many pieces;
  /// traces the pieces from `first` to before `last`, in parallel. Indices of the prisms rise.
  AzimuthLight(const TracedPrisms& prisms, const RotationColumns<double>& rest, std::vector<double> elevations,
               double turn, int pieces, int first, int last);

  int first() const { return first_; }
  int last() const { return last_; }
  int columns() const { return pieces_ * kPiece; }
  double azimuthAt(double column) const { return turn_ * column / columns(); }

  const RotationColumns<double>& rest() const { return rest_; }
  double elevation(std::size_t row) const { return elevations_[row]; }

  /// The light of one elevation in crystals of a piece's azimuths.
  const LightRow& piece(std::size_t row, int piece) const {
    return lights_[static_cast<std::size_t>(piece - first_) * elevations_.size() + row];
  }

  /// Classes that have light in a piece, at any elevation.
  std::vector<int> classesIn(int piece) const;

  /// How much of each index's light makes that of another one, between two of them.
  std::vector<double> partsOf(double index) const;

  /// In the crystal's frame, the light of a sun of an elevation, for a crystal of an azimuth counter-clockwise from the
  /// sun's (rad).
  Triple<double> lightDirAt(double elevation, double azimuth) const;

  /// More or less, how much of the light that crystals intercept is wanted.
  double wantedShare() const;

  long directions() const;

 private:
  LightRow traced(double elevation, int piece) const;

  TracedPrisms prisms_;
  RotationColumns<double> rest_;
  std::vector<double> elevations_;
  double turn_;
  int pieces_, first_, last_;
  std::vector<LightRow> lights_;  // by piece and elevation
};

}  // namespace parhelion
