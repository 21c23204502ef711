// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <variant>

namespace parhelion {

// One struct a method, with the meaning and the source of each in the method's own header. Lengths are in pixels.

/// The plain radiance: each pixel's light over its solid angle.
struct NoSettings {};

/// One Gaussian for the whole picture.
struct GaussianSettings {
  std::optional<double> sigma;  // its standard deviation; empty: by the number of hits
};

/// The mean of several Gaussians, of standard deviation 1, 2, 4, ...
struct GlassnerSettings {
  int scales = 6;
};

/// What a hit says: the value of the picture where it fell, or how dense the hits are around it.
enum class HitReading { intensities, densities };

/// One low-pass filter for the whole picture, over all pixels with the empty ones as 0, then iterations.
struct MarvastiSettings {
  std::optional<double> period;  // Ts of the low-pass; empty: by the number of hits
  int iterations = 0;
  double relaxation = 1.0;  // factor of the first picture and of each correction
};

/// Every pixel takes the value of the nearest hit, then a low-pass filter, then iterations.
struct VoronoiSettings {
  HitReading reading = HitReading::densities;
  std::optional<double> period;
  int iterations = 0;
};

/// Adaptive weights and conjugate gradients: the trigonometric polynomial that fits the hits best.
struct ActSettings {
  HitReading reading = HitReading::densities;
  std::optional<double> period;
  int iterations = 3;
};

/// Whether kernels add up to 1, or are used as the windowed sinc has them.
enum class KernelGain { unit, paper };

/// Whether a kernel's size is chosen where light comes from (scatter) or where it goes to (gather).
enum class KernelFlow { scatter, gather };

/// Windowed-sinc kernels whose size follows the hits: squares grow until they hold enough.
struct GonzatoMarchandSettings {
  std::optional<double> samples;  // m, hits in a square; empty: by the number of hits
  double lobes = 1.0;             // k, zeros of the sinc inside a kernel
  int iterations = 0;
  KernelGain gain = KernelGain::unit;
  KernelFlow flow = KernelFlow::scatter;
};

/// Filters as wide and as long as each place of the sky allows.
struct AdaptiveSettings {};

/// How scattered hits become an image. The order is that of the names in scene files (scene/names.h).
using ReconSettings = std::variant<AdaptiveSettings, NoSettings, GaussianSettings, GlassnerSettings, MarvastiSettings,
                                   VoronoiSettings, ActSettings, GonzatoMarchandSettings>;

}  // namespace parhelion
