// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "beam/pixel_film.h"
#include "beam/sheet_totals.h"
#include "beam/sky_integral.h"
#include "sky/lens.h"

namespace parhelion {

/// Numbers in (0, 1), evenly spread in each dimension and together: additive, by powers of the inverse of the root of
/// x^(d + 1) = x + 1 (Roberts 2018, the R sequence), with a start of its own for each group.
class EvenPoints {
 public:
  static constexpr int kDimensions = 5;

  EvenPoints(std::uint64_t seed, int group);

  double at(int point, int dimension) const;

 private:
  std::array<double, kDimensions> step_{}, start_{};
};

/// Integrates a sky by sheets of orientations, until its stated error is what is aimed at: with more sheets, or with
/// finer meshes of them, whichever is in the way most.
class SheetIntegration {
 public:
  virtual ~SheetIntegration() = default;

  SkyIntegral run();

 protected:
  static constexpr int kFilms = 8;  // of all sheets, and of groups

  /// One sheet, whose meshes have twice as many cells each way as the last; all that a mesh has, which make the light
  /// together and come to the films by turns; or groups of ever more sheets, each group spread evenly by itself: by how
  /// much they differ, their mean errs.
  enum class Sheets { one, all, groups };

  /// The scene must outlive this.
  SheetIntegration(const AxisScene& scene, const SkyAccuracy& accuracy, const Camera& camera, Sheets sheets,
                   int mostLevel);

  /// Starts meshes of a level of fineness, from 0 to the highest.
  virtual void start(int level) = 0;
  /// Adds the sheets of points from `first` to before `last` to films and their totals. Returns how many they are.
  virtual long add(int first, int last, bool coarse) = 0;
  /// Of light, that were traced; and about how much of it is wanted.
  virtual long directions() const = 0;
  virtual double wantedShare() const = 0;

  /// Light to a pixel, of one sheet, that does not matter to the accuracy.
  double faintest() const;

  const AxisScene& scene_;
  SkyAccuracy accuracy_;
  Lens lens_;
  std::vector<PixelFilm> films_;
  std::vector<SheetTotals> totals_;  // by film

 private:
  void startMesh(int level);
  void extend(int points);
  void judge();

  Sheets sheets_;
  int mostLevel_, level_ = 0, points_ = 0;
  std::vector<double> previous_;  // Y of a single sheet at the last level
  double outer_ = 0.0, mesh_ = 0.0;
  SkyIntegral result_;
};

}  // namespace parhelion
