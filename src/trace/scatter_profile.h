// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "trace/bundle_bins.h"
#include "trace/measuring_film.h"
#include "trace/traced_rays.h"

namespace parhelion {

/// Light over the scattering angle, the angle from the direction of the unscattered light, and the quantities of single
/// scattering that follow from it. Lengths in units of the hexagon's side.
class ScatterProfile : public MeasuringFilm {
 public:
  /// Encounters whose light is told one by one. Plates and columns hold a little light for some thousand more.
  static constexpr std::size_t kOrders = 32;

  /// `bins` equal bins over [from, to] (rad, within [0, pi]); light outside them counts for the summary only.
  ScatterProfile(int bins, double from, double to);

  int add(const TracedRays& traced) override;
  std::unique_ptr<Film> forThread() override;

  double from() const { return from_; }  // rad
  double to() const { return to_; }

  struct Bin {
    double from, to;  // rad
    double energy;    // share of all intercepted light
    double error;     // its standard error (BundleBins::shareError())
    double phase;     // 4 pi energy / solid angle of the bin
  };
  std::vector<Bin> bins() const;

  /// Bin `i` of those that are `width` wide and begin at `from`, with its energy and error.
  static Bin binOf(int i, double from, double width, double energy, double error);

  struct Summary {
    std::uint64_t rays;
    double g, gError;                // mean cosine of the scattering angle, and its standard error
    double undeviated;               // share that goes on as if there were no crystal
    double external;                 // share reflected at the outside
    std::vector<double> byOrder;     // share leaving at internal encounter k < kOrders; 0 is external
    double byOrderRest;              // share leaving at all later ones together
    double meanPath, meanPathError;  // energy-weighted internal path per intercepted ray, and its standard error
    double volume, surface, meanProjectedArea;  // of the mean crystal of the cloud
    double cutOff, lost;                        // shares
  };
  Summary summary() const;

 private:
  static constexpr int kNoBin = -1;
  int binAt(double angle) const;

  void addExit(const TracedRays& traced, int exit);
  /// The totals, kIntercepted being the first.
  enum Total : std::size_t {
    kUndeviated = kIntercepted + 1,
    kCosine,
    kCosineSquared,
    kPath,
    kPathSquared,
    kCutOff,
    kLost,
    // Sums over rays of 1, 1 / A, S / A, V / A; A is the projected area.
    kWeight,
    kPerArea,
    kSurfacePerArea,
    kVolumePerArea,
    kOrderRest,
    kFirstOrder,
    kTotalCount = kFirstOrder + kOrders
  };
  static std::array<std::string, kTotalCount> namesOfTotals();
  static const std::array<std::string, kTotalCount> kTotals;

  void addRay(const TracedRays& traced, int member, int place);

  /// Standard error of `sum` over the intercepted light, from the sum of its squares per bundle.
  double errorOf(Total sum, Total squares) const;

  double from_, to_, width_;
  BundleDeposits<double> deposits_;
  ByBundle byBundle_;
  double bundleCosine_ = 0.0, bundlePath_ = 0.0;  // light times cosine and internal path, of the bundle being added
};

}  // namespace parhelion
