// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "beam/light_table.h"
#include "beam/orientation_sheet.h"
#include "beam/pixel_film.h"
#include "sky/camera.h"

namespace parhelion {

/// Where the pixels of a picture look, for lookups of many points in each.
class PixelDirections {
 public:
  explicit PixelDirections(const Camera& camera);

  const Camera& camera() const { return camera_; }

  /// Solid angle (sr) of a pixel; 0 where it shows no sky.
  double solidAngle(std::size_t pixel) const { return solidAngles_[pixel]; }

  /// Whether all of a pixel shows sky and its corners are close together.
  bool isWhole(int x, int y) const;

  /// The direction at a place in a whole pixel, each coordinate from 0 to 1; unit to second order.
  Vec3 within(int x, int y, double u, double v) const;

  /// The angle across a pixel's diagonal, rad.
  double size(int x, int y) const;

 private:
  const Vec3& corner(int x, int y) const {
    return corners_[static_cast<std::size_t>(y) * static_cast<std::size_t>(camera_.width() + 1) +
                    static_cast<std::size_t>(x)];
  }

  Camera camera_;
  std::vector<Vec3> corners_;  // 0 where there is no sky
  std::vector<double> solidAngles_;
};

/// How finely bands are cut.
struct BandMesh {
  double band = 0.0;   // thickness, rad
  double ring = 0.0;   // of the sky about the sun, rad
  double cell = 0.0;   // along the rings, rad of azimuth
  bool coarse = true;  // the film's fourth sum is wanted
};

/// All orientations of crystals whose c axes have any distribution of tilts, with all azimuths and rolls alike, and the
/// light of one point of the sun at one index.
///
/// What a crystal does to light depends on the angle alpha between its c axis and the light and on its roll about c.
/// Turning it about the light turns its light around the sun, no more. So for a band of alpha the sky about the sun is
/// that of one azimuth psi of c about the sun, all rolls together, convolved along the rings with the distribution of
/// psi within the band. The sky is summed in rings and cells about the sun, which pixels then take their means of.
///
/// A film's sums are those of OrientationSheet; its fourth is from bands and rolls of twice the size.
class TiltBands {
 public:
  /// Table and directions must outlive this. `tilt` is the inverse of the distribution of tilts (rad).
  TiltBands(const LightTable& table, const PixelDirections& directions, std::function<double(double)> tilt,
            const BandMesh& mesh);

  SheetTotals add(const SheetPoint& point, PixelFilm& film);

 private:
  using Four = Lanes<4>::Real;
  struct Row {
    bool dark = true;
    std::vector<double> light, density, excess, place, turn;  // place among the rings; azimuth about the sun, in cells
  };
  /// A corner of a triangle.
  struct Corner {
    double alpha, phi, light, density, excess, place, turn;
  };
  /// The distribution of psi within a band: how much in which cell, from `first` on.
  struct Azimuths {
    std::size_t first = 0;
    std::vector<float> share;
    double all = 0.0;
  };
  /// Light about the sun, by ring and cell; cells go on beyond both ends of [0, pi] until it is folded.
  struct Rings {
    std::vector<float> light;
  };

  void distribute();
  void see(double alpha, int number, Row& row);
  void addBand(const Row& a, double alphaA, const Row& b, double alphaB, int step, const Azimuths& azimuths,
               Rings& rings);
  void addTriangle(const Corner& a, const Corner& b, const Corner& c, double share, const Azimuths& azimuths,
                   Rings& rings);
  void addTurned(std::size_t ring, double light, double turn, double width, const Azimuths& azimuths, Rings& rings);
  Corner exitAt(Corner corner) const;
  void fold(Rings& rings) const;
  void expose(PixelFilm& film) const;

  const LightTable& table_;
  const PixelDirections& directions_;
  std::function<double(double)> tilt_;
  int bands_;          // over a quarter turn
  std::size_t rings_;  // over half a turn
  std::size_t cells_;  // over half a turn
  SheetPoint point_;
  Vec3 distributedFor_{0.0};
  std::vector<Azimuths> azimuths_;  // by band
  std::vector<double> parts_;
  int class_ = 0;
  bool wantsCoarse_;
  Rings fine_, coarse_;
};

}  // namespace parhelion
