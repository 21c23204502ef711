// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "math/exact_sum.h"
#include "trace/bundle_bins.h"
#include "trace/film.h"
#include "trace/named_totals.h"

namespace parhelion {

/// Light over the scattering angle, the angle from the direction of the unscattered light, and the quantities of single
/// scattering that follow from it. Lengths in units of the hexagon's side.
class ScatterProfile : public Film {
 public:
  /// Encounters whose light is told one by one. Plates and columns hold a little light for some thousand more.
  static constexpr std::size_t kOrders = 32;

  /// `bins` equal bins over [from, to] (rad, within [0, pi]); light outside them counts for the summary only.
  ScatterProfile(int bins, double from, double to);

  int add(const TracedRays& traced) override;
  std::unique_ptr<Film> forThread() override;
  void merge(Film& fromThread) override;
  void visitSums(SumVisitor& visitor) override;
  double fullness() const override { return bins_.fullness(); }

  /// All that it has summed, for files and for adding profiles of different rays. setTotals() takes what totals()
  /// gives: throws std::out_of_range where one is missing.
  NamedTotals totals() const;
  void setTotals(const NamedTotals& totals);
  const BundleBins& sums() const { return bins_; }
  BundleBins& sums() { return bins_; }

  double from() const { return from_; }  // rad
  double to() const { return to_; }

  struct Bin {
    double from, to;  // rad
    double energy;    // share of all intercepted light
    double error;     // its standard error (BundleBins::shareError())
    double phase;     // 4 pi energy / solid angle of the bin
  };
  std::vector<Bin> bins() const;

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
  ScatterProfile empty() const { return {bins_.size(), from_, to_}; }
  int binAt(double angle) const;

  void addExit(const TracedRays& traced, int exit);
  /// The totals that have a name of their own.
  struct Total {
    const char* name;
    ExactSum ScatterProfile::*sum;
  };
  static const std::array<Total, 13> kTotals;

  ExactSum& orderSum(std::size_t order);
  void addRay(const TracedRays& traced, int member, int place);

  /// Standard error of `sum` over the intercepted light, from the sum of its squares per bundle.
  double errorOf(const ExactSum& sum, const ExactSum& squares) const;

  double from_, to_, width_;
  BundleBins bins_;
  BundleDeposits<double> deposits_;
  ByBundle byBundle_;
  double bundleCosine_ = 0.0, bundlePath_ = 0.0;  // light times cosine and internal path, of the bundle being added

  std::uint64_t rays_ = 0, bundles_ = 0;
  ExactSum intercepted_, undeviated_, cosine_, cosineSquared_, path_, pathSquared_, cutOff_, lost_;
  ExactSum weight_, perArea_, surfacePerArea_,
      volumePerArea_;              // sums over rays of 1, 1 / A, S / A, V / A; A the projected area
  std::vector<ExactSum> byOrder_;  // at most kOrders
  ExactSum byOrderRest_;
};

}  // namespace parhelion
