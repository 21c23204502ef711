// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "recon/hit_map.h"

namespace parhelion {

/// A convolution by a kernel that is even in both directions, through the Fourier transform.
class LowPass {
 public:
  /// `transfer` holds what becomes of each frequency; its size, at least that of the pictures, is the period in which
  /// they are continued by zeros.
  explicit LowPass(Raster<double> transfer) : transfer_(std::move(transfer)) {}

  /// The filtered pictures. All have one size.
  std::vector<Raster<double>> operator()(const std::vector<Raster<double>>& pictures) const;

 private:
  void filterPair(const std::vector<Raster<double>>& pictures, std::size_t first,
                  std::vector<Raster<double>>& out) const;

  Raster<double> transfer_;
};

/// Whether a low-pass of the sampling period Ts (pixels) passes kx waves in `periodX` pixels and ky in `periodY`:
/// a disc of frequencies up to 1/(2 Ts).
bool passes(int kx, int periodX, int ky, int periodY, double period);

/// The ideal low-pass of a torus.
LowPass idealLowPass(int width, int height, double period);

/// The windowed sinc of sinc_kernel.h with unit gain, in pictures whose edges touch or not.
LowPass sincLowPass(int width, int height, double period, bool wrapX, bool wrapY);

/// A low-pass that knows where the sky ends: K * (omega v) / K * omega, 0 without sky. A constant stays constant up to
/// the border.
class SkyLowPass {
 public:
  SkyLowPass(const HitMap& map, double period);

  /// What becomes of pictures of light per pixel: light per relative solid angle.
  std::vector<Raster<double>> operator()(const std::vector<Raster<double>>& light) const;

 private:
  LowPass filter_;
  Raster<double> gain_;  // 1 / (K * omega), 0 without sky
};

}  // namespace parhelion
