// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <variant>

namespace parhelion {

// One struct a method, with the word for it in scene files. Meaning and source of each are in methods.h. Lengths are in
// pixels.

/// The plain radiance: each pixel's light over its solid angle.
struct NoSettings {
  static constexpr std::string_view kName = "none";
};

/// One Gaussian for the whole picture.
struct GaussianSettings {
  static constexpr std::string_view kName = "gaussian";
  std::optional<double> sigma;  // its standard deviation; empty: by the number of hits
};

/// The mean of several Gaussians, of standard deviation 1, 2, 4, ...
struct GlassnerSettings {
  static constexpr std::string_view kName = "glassner";
  int scales = 6;
};

/// What a hit says: the value of the picture where it fell, or how dense the hits are around it.
enum class HitReading { intensities, densities };

constexpr std::string_view nameOf(HitReading value) {
  switch (value) {
    case HitReading::intensities:
      return "intensities";
    case HitReading::densities:
      return "densities";
  }
  return {};
}

/// One low-pass filter for the whole picture, over all pixels with the empty ones as 0, then iterations.
struct MarvastiSettings {
  static constexpr std::string_view kName = "marvasti";
  std::optional<double> period;  // Ts of the low-pass; empty: by the number of hits
  int iterations = 0;
  double relaxation = 1.0;  // factor of the first picture and of each correction
};

/// Every pixel takes the value of the nearest hit, then a low-pass filter, then iterations.
struct VoronoiSettings {
  static constexpr std::string_view kName = "voronoi";
  HitReading reading = HitReading::densities;
  std::optional<double> period;
  int iterations = 0;
};

/// Adaptive weights and conjugate gradients: the trigonometric polynomial that fits the hits best.
struct ActSettings {
  static constexpr std::string_view kName = "act";
  HitReading reading = HitReading::densities;
  std::optional<double> period;
  int iterations = 3;
};

/// Whether kernels add up to 1, or are used as the windowed sinc has them.
enum class KernelGain { unit, paper };

constexpr std::string_view nameOf(KernelGain value) {
  switch (value) {
    case KernelGain::unit:
      return "unit";
    case KernelGain::paper:
      return "paper";
  }
  return {};
}

/// Whether a kernel's size is chosen where light comes from (scatter) or where it goes to (gather).
enum class KernelFlow { scatter, gather };

constexpr std::string_view nameOf(KernelFlow value) {
  switch (value) {
    case KernelFlow::scatter:
      return "scatter";
    case KernelFlow::gather:
      return "gather";
  }
  return {};
}

/// Windowed-sinc kernels whose size follows the hits: squares grow until they hold enough.
struct GonzatoMarchandSettings {
  static constexpr std::string_view kName = "gonzato-marchand";
  std::optional<double> samples;  // m, hits in a square; empty: by the number of hits
  double lobes = 1.0;             // k, zeros of the sinc inside a kernel
  int iterations = 0;
  KernelGain gain = KernelGain::unit;
  KernelFlow flow = KernelFlow::scatter;
};

/// Filters as wide and as long as each place of the sky allows.
struct AdaptiveSettings {
  static constexpr std::string_view kName = "adaptive";
};

/// How scattered hits become an image; the first is the one that is taken when nothing is said.
using ReconSettings = std::variant<AdaptiveSettings, NoSettings, GaussianSettings, GlassnerSettings, MarvastiSettings,
                                   VoronoiSettings, ActSettings, GonzatoMarchandSettings>;

}  // namespace parhelion
