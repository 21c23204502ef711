// SPDX-License-Identifier: Apache-2.0
#include "recon/adaptive/kernel_bank.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "math/conventions.h"
#include "math/portable.h"

namespace parhelion {
namespace {

constexpr double kNarrowest = 0.3;  // cells; narrower kernels are a single cell anyway
constexpr double kWidest = 2.0;     // cells
constexpr double kSupport = 10.0;   // of the quadratic form

double widthOf(int index, int count) {
  const double octaves = portable::log(kWidest / kNarrowest) * index / (count - 1);
  return kNarrowest * portable::exp(octaves);
}

/// A monotonic stand-in for the angle of (p, q), from 0 to 4 in a full turn: no arctangent needed.
float diamondAngle(float p, float q) {
  const float sum = std::abs(p) + std::abs(q);
  if (sum == 0.0F) return 0.0F;
  const float t = q / sum;
  if (p < 0.0F) return 2.0F - t;
  return t < 0.0F ? 4.0F + t : t;
}

}  // namespace

float roughLog2(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const int exponent = static_cast<int>(bits >> 23) - 127;
  const float f = std::bit_cast<float>((bits & 0x007fffffU) | 0x3f800000U) - 1.0F;
  return static_cast<float>(exponent) + f + 0.3431F * f * (1.0F - f);
}

KernelShape KernelShape::stretched(float factor) const {
  if (factor == 1.0F) return *this;
  const float m = std::sqrt(1.0F + p * p + q * q);
  const KernelShape longer{0.5F * ((m + p) * factor - (m - p) / factor), q};
  constexpr float kMost = 0.5F * (KernelBank::kMaxAspect - 1.0F / KernelBank::kMaxAspect);
  const float shrink = std::min(kMost / std::sqrt(longer.p * longer.p + longer.q * longer.q), 1.0F);
  return {shrink * longer.p, shrink * longer.q};
}

Kernel::Kernel(double minor, double major, double angle) {
  const auto [s, c] = portable::sincos(angle);
  const double a2 = 1.0 / (major * major), b2 = 1.0 / (minor * minor);
  const double xx = c * c * a2 + s * s * b2, xy = c * s * (a2 - b2), yy = s * s * a2 + c * c * b2;
  const auto form = [&](int x, int y) { return xx * x * x + 2.0 * xy * x * y + yy * y * y; };

  const int limit = static_cast<int>(std::sqrt(kSupport) * major) + 1;
  rowReach_ = 0;
  for (int y = 0; y <= limit; ++y) {
    for (int x = -limit; x <= limit; ++x) {
      if (form(x, y) < kSupport) rowReach_ = y;
    }
  }
  double sum = 0.0;
  std::vector<double> weights;
  for (int y = -rowReach_; y <= rowReach_; ++y) {
    Span span{0, 0, static_cast<int>(weights.size())};
    for (int x = -limit; x <= limit; ++x) {
      const double rest = 1.0 - form(x, y) / kSupport;
      if (rest <= 0.0) continue;
      if (span.count++ == 0) span.from = x;
      weights.push_back(rest * rest * rest);
      sum += weights.back();
      columnReach_ = std::max(columnReach_, std::abs(x));
    }
    spans_.push_back(span);
  }
  for (const double weight : weights) weights_.push_back(static_cast<float>(weight / sum));
}

KernelBank::KernelBank() {
  for (int w = 0; w < kWidths; ++w) {
    const double minor = widthOf(w, kWidths);
    for (int a = 0; a < kAspects; ++a) {
      const double aspect = std::sqrt(static_cast<double>(1 << a));
      for (int t = 0; t < kAngles; ++t) kernels_.emplace_back(minor, minor * aspect, kPi * t / kAngles);
    }
  }
  for (int sector = 0; sector < kSectors; ++sector) {
    const double d = 4.0 * (sector + 0.5) / kSectors;  // diamond angle
    const double q = d < 1.0 ? d : d < 3.0 ? 2.0 - d : d - 4.0;
    const double p = (d < 1.0 || d >= 3.0 ? 1.0 : -1.0) * (1.0 - std::abs(q));
    const double turn = 0.5 * portable::atan2(q, p) / kPi;  // of half a turn, -1/2 to 1/2
    angleOfSector_[static_cast<std::size_t>(sector)] = (static_cast<int>(turn * kAngles + kAngles + 0.5)) % kAngles;
  }
}

int KernelBank::angleIndex(KernelShape shape) const {
  const int sector = static_cast<int>(diamondAngle(shape.p, shape.q) * (kSectors / 4.0F));
  return angleOfSector_[static_cast<std::size_t>(std::min(sector, kSectors - 1))];
}

const Kernel& KernelBank::nearest(float variance, KernelShape shape, float blur) const {
  constexpr float kLeastVariance = 1e-4F;  // cells^2, a single cell
  const float aspect = shape.aspect();
  const float minor2 = std::max(variance / aspect - blur, kLeastVariance);
  const float major2 = std::max(variance * aspect - blur, minor2);
  constexpr float kLog2Narrowest = -1.7369656F;
  constexpr float kStepsPerOctave = (kWidths - 1) / (1.0F - kLog2Narrowest);
  const float width = (0.5F * roughLog2(minor2) - kLog2Narrowest) * kStepsPerOctave + 0.5F;
  const float ratio = roughLog2(major2 / minor2) + 0.5F;
  const int w = static_cast<int>(std::clamp(width, 0.0F, kWidths - 1.0F));
  const int a = static_cast<int>(std::clamp(ratio, 0.0F, kAspects - 1.0F));
  return kernels_[static_cast<std::size_t>((w * kAspects + a) * kAngles + (a == 0 ? 0 : angleIndex(shape)))];
}

const KernelBank& kernelBank() {
  static const KernelBank bank;
  return bank;
}

}  // namespace parhelion
