// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "beam/azimuth_light.h"
#include "beam/sheet_cells.h"
#include "beam/sheet_totals.h"
#include "beam/tristimulus.h"

namespace parhelion {

/// Light of one point of the sun and of one index.
struct AzimuthRow {
  std::size_t elevation;  // AzimuthLight's
  double azimuth;         // of the point, rad, from world +x toward +y
  double index;
  double weight;  // the mean of all rows' by the trapezoidal rule is 1
};

/// Rows between which all is smooth, and the colours of the light between each and the next; or one row and its
/// colour.
struct AzimuthStrip {
  std::vector<AzimuthRow> rows;
  std::vector<Tristimulus> xyz;
  double share = 1.0;   // of all light
  double coarse = 1.0;  // the same in a mesh of half as many cells each way; 0 if it is none of that
};

/// Puts the light of crystals of all azimuths that stand alike otherwise into a picture. A sheet is a mesh of triangles
/// by the azimuth and from row to row; see OrientationSheet. A row by itself makes lines.
class AzimuthSheet {
 public:
  /// `light` must outlive this.
  AzimuthSheet(const AzimuthLight& light, const Lens& lens, const SheetPicture& picture);

  /// Adds what the light's pieces have of a strip, with an even number of cells, if any. Sums of the film as
  /// OrientationSheet has them.
  SheetTotals add(const AzimuthStrip& strip, PixelFilm& film);

 private:
  using Four = SheetCells::Four;

  /// A row's light and its nodes in a piece, and where the class that is being added is seen.
  struct Row {
    SheetNodes nodes;
    std::vector<double> x, y, z;   // of the light, in the crystal's frame
    std::vector<double> sin, cos;  // of the crystals' azimuths, world
    std::vector<double> parts;
  };

  void place(Row& row, const AzimuthRow& at);
  void addClass(PixelFilm& film);
  void addBetween(std::size_t first, std::size_t step, PixelFilm& film) const;
  void addLine(int step, PixelFilm& film) const;
  void see(Row& row, const AzimuthRow& at) const;
  SheetCorner cornerOf(std::size_t row, int column) const;
  SheetCorner exitAt(SheetCorner corner) const;

  const AzimuthLight& light_;
  Lens lens_;
  SheetCells cells_;
  // Of the strip, the piece and the class that are being added.
  AzimuthStrip strip_;
  std::vector<Row> rows_;
  int piece_ = 0, class_ = 0;
};

}  // namespace parhelion
