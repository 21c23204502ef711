// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "beam/crystal_side.h"
#include "beam/light_table.h"
#include "beam/sheet_cells.h"
#include "beam/sheet_totals.h"
#include "beam/tristimulus.h"
#include "sky/lens.h"

namespace parhelion {

/// All azimuths and rolls of crystals whose c axis has one tilt, and the light of one point of the sun at one index.
struct SheetPoint {
  Vec3 toSun;         // unit, world
  double tilt = 0.0;  // of c from the zenith, rad
  double index = 1.31;
  double offset = 0.0;  // of the mesh, from 0 to 1 cell
  Tristimulus xyz{};    // of all its light
};

/// How finely it is cut up.
struct SheetMesh : SheetPicture {
  double step = 0.0;   // of c and of the roll, rad
  bool folds = false;  // the film is mirrored afterwards in the sun's vertical plane: half the azimuths do
  bool coarse = true;  // the film's fourth sum is wanted
  CrystalSide side = CrystalSide::both;
};

/// Puts the light of a sheet of orientations into a picture. The sheet is a mesh of triangles, by the azimuth of c and
/// by the azimuth of the light about c. Each class of light maps a triangle to one of the sky: its corners are exact,
/// and place and light are linear between them.
///
/// A film's four sums are X, Y, Z, and Y from a mesh of half as many cells each way.
class OrientationSheet {
 public:
  /// Both must outlive this. The table must be prepared for all angles that are asked for.
  OrientationSheet(const LightTable& table, const Lens& lens, const SheetMesh& mesh);

  SheetTotals add(const SheetPoint& point, PixelFilm& film);

  /// Angles between -c and the light, of all azimuths at a tilt.
  static std::array<double, 2> anglesAt(double tilt, const Vec3& toSun);

 private:
  using Four = Lanes<4>::Real;

  /// Crystals of one azimuth: c, the light's part across it, and what is at right angles to both.
  struct Frame {
    double azimuth, zeta;
    Triple<double> across, beside, c;
    double sinZeta, cosZeta;
    double weight = 0.0;  // of the trapezoidal rule
  };
  /// Azimuths in a row, between which all is smooth.
  struct Run {
    std::vector<Frame> frames;  // an odd number
    bool upper;                 // the light meets the upper end; else they are those of -c
  };
  struct Nodes : SheetNodes {
    explicit Nodes(std::size_t room = 0) : SheetNodes(room), along(room), aside(room), up(room) {}

    std::vector<double> along, aside, up;  // direction of the light, by across, beside and c
  };

  Frame frameAt(double azimuth, bool upper) const;
  std::vector<Run> runs() const;
  void addClass(const Run& run, int number, PixelFilm& film);
  void see(const Frame& frame, int number, Nodes& nodes);
  void addRow(const Frame& a, const Nodes& na, const Frame& b, const Nodes& nb, int step, PixelFilm& film) const;
  void addLines(const Frame& frame, const Nodes& nodes, int step, PixelFilm& film) const;
  SheetCorner cornerOf(const Frame& frame, const Nodes& nodes, int column, int view) const;
  SheetCorner exitAt(SheetCorner corner, int view) const;
  Triple<double> inView(int view, const Frame& frame, double along, double aside, double up) const;
  PARHELION_INLINE Four perLight(int step) const;

  const LightTable& table_;
  Lens lens_;
  SheetMesh mesh_;
  SheetCells cells_;
  int views_;
  // Of the sheet and the class that are being added.
  SheetPoint point_;
  Triple<double> level_, left_;  // horizontal: the sun's azimuth, and across it
  std::vector<double> parts_;
  bool upper_ = true;
  int class_ = 0;
  std::array<Nodes, 3> nodes_;
};

}  // namespace parhelion
