// SPDX-License-Identifier: Apache-2.0
#pragma once

// Fluxes of a slab of haze by adding and doubling: Hansen & Travis 1974, Space Science Reviews 16, section 3, for the
// mean over azimuths of intensities. Written for tests alone, and small.

#include <cmath>
#include <vector>

#include "math/conventions.h"
#include "math/gauss_legendre.h"

namespace parhelion::test {

/// Light that falls on a slab along one direction: what of its flux comes back, and what gets through, the direct light
/// included.
struct SlabFlux {
  double reflected, transmitted;
};

class AddingDoubling {
 public:
  /// A slab of conservative Henyey-Greenstein haze under light at the sine `sunRise` of the elevation.
  AddingDoubling(double g, double depth, double sunRise) : depth_(depth) {
    const auto nodes = gaussLegendre(kNodes);
    for (int i = 0; i < kNodes; ++i) {
      rise_.push_back(0.5 * (1.0 + nodes[static_cast<std::size_t>(i)].x));
      weight_.push_back(nodes[static_cast<std::size_t>(i)].weight * rise_.back());  // 2 mu w, w being half the weight
    }
    rise_.push_back(sunRise);
    weight_.push_back(0.0);
    const double thin = std::ldexp(depth, -kDoublings);
    for (Matrix* m : {&r_, &t_}) *m = Matrix(kSize, std::vector<double>(kSize));
    for (int i = 0; i < kSize; ++i)
      for (int j = 0; j < kSize; ++j) {
        const double both = thin / (4.0 * rise_[i] * rise_[j]);
        r_[i][j] = both * phase(g, -rise_[i], rise_[j]);
        t_[i][j] = both * phase(g, rise_[i], rise_[j]);
      }
    for (int k = 0; k < kDoublings; ++k) doubleUp(std::ldexp(depth, k - kDoublings));
  }

  SlabFlux ofSun() const { return fluxOf(kNodes); }

  /// Of light that comes evenly from the whole sky.
  SlabFlux diffuse() const {
    SlabFlux all{0.0, 0.0};
    for (int j = 0; j < kNodes; ++j) {
      const SlabFlux one = fluxOf(j);
      all.reflected += weight_[j] * one.reflected;
      all.transmitted += weight_[j] * one.transmitted;
    }
    return all;
  }

 private:
  static constexpr int kNodes = 32, kSize = kNodes + 1, kDoublings = 25;
  using Matrix = std::vector<std::vector<double>>;

  /// Mean over azimuths, by Legendre's polynomials; 1 for isotropic haze.
  static double phase(double g, double a, double b) {
    double sum = 0.0, power = 1.0, pa = 1.0, pb = 1.0, beforeA = 0.0, beforeB = 0.0;
    for (int l = 0; l < 2 * kNodes; ++l) {
      sum += (2 * l + 1) * power * pa * pb;
      power *= g;
      const double nextA = ((2 * l + 1) * a * pa - l * beforeA) / (l + 1),
                   nextB = ((2 * l + 1) * b * pb - l * beforeB) / (l + 1);
      beforeA = pa;
      beforeB = pb;
      pa = nextA;
      pb = nextB;
    }
    return sum;
  }

  Matrix times(const Matrix& a, const Matrix& b) const {
    Matrix c(kSize, std::vector<double>(kSize));
    for (int i = 0; i < kSize; ++i)
      for (int k = 0; k < kNodes; ++k)
        for (int j = 0; j < kSize; ++j) c[i][j] += a[i][k] * weight_[k] * b[k][j];
    return c;
  }
  static void add(Matrix& to, const Matrix& more) {
    for (int i = 0; i < kSize; ++i)
      for (int j = 0; j < kSize; ++j) to[i][j] += more[i][j];
  }

  /// Two slabs like this one, of that depth each, on each other.
  void doubleUp(double depth) {
    std::vector<double> direct;
    for (const double rise : rise_) direct.push_back(std::exp(-depth / rise));
    const auto before = [&](Matrix m) {  // the direct light comes in
      for (auto& row : m)
        for (int j = 0; j < kSize; ++j) row[j] *= direct[j];
      return m;
    };
    const auto after = [&](Matrix m) {
      for (int i = 0; i < kSize; ++i)
        for (double& one : m[i]) one *= direct[i];
      return m;
    };
    // The series q + q^2 + ..., of which each round doubles the terms.
    Matrix power = times(r_, r_), s = power;
    for (int n = 0; n < 10; ++n) {
      add(s, times(s, power));
      power = times(power, power);
    }
    Matrix down = t_;
    add(down, times(s, t_));
    add(down, before(s));
    Matrix up = times(r_, down);
    add(up, before(r_));
    Matrix r = r_;
    add(r, after(up));
    add(r, times(t_, up));
    Matrix t = after(down);
    add(t, before(t_));
    add(t, times(t_, down));
    r_ = std::move(r);
    t_ = std::move(t);
  }

  SlabFlux fluxOf(int j) const {
    SlabFlux flux{0.0, std::exp(-depth_ / rise_[j])};
    for (int i = 0; i < kNodes; ++i) {
      flux.reflected += weight_[i] * r_[i][j];
      flux.transmitted += weight_[i] * t_[i][j];
    }
    return flux;
  }

  double depth_;
  std::vector<double> rise_, weight_;
  Matrix r_, t_;
};

}  // namespace parhelion::test
