// SPDX-License-Identifier: Apache-2.0
#pragma once

// The words that scene files, statistics and summaries use for the values of enumerations.

#include <array>
#include <span>
#include <string_view>
#include <variant>

#include "scene/scene.h"

namespace parhelion {

template <class E>
struct Named {
  std::string_view name;
  E value;
};

/// The words of a [[population]] from which its shape and orientation follow.
enum class ShapeName { prism, pyramid };
enum class OrientationName { random, plate, column, parry, lowitz };

/// The alternatives of ReconSettings, in its order.
enum class ReconMethod { adaptive, none, gaussian, glassner, marvasti, voronoi, act, gonzatoMarchand };

inline constexpr auto kEngineNames = std::to_array<Named<Engine>>({
    {"embree", Engine::embree},
    {"embree-robust", Engine::embreeRobust},
    {"planes", Engine::planes},
    {"auto", Engine::automatic},
});
inline constexpr auto kPathModeNames = std::to_array<Named<PathMode>>({
    {"split", PathMode::split},
    {"chance", PathMode::chance},
});
inline constexpr auto kSimdNames = std::to_array<Named<Simd>>({
    {"auto", Simd::automatic},
    {"baseline", Simd::baseline},
    {"avx2", Simd::avx2},
    {"avx512", Simd::avx512},
});
inline constexpr auto kSamplerNames = std::to_array<Named<Sampler>>({
    {"random", Sampler::random},
    {"sobol", Sampler::sobol},
});
inline constexpr auto kSymmetryNames = std::to_array<Named<Symmetry>>({
    {"auto", Symmetry::automatic},
    {"none", Symmetry::none},
    {"mirror", Symmetry::mirror},
    {"radial", Symmetry::radial},
});
inline constexpr auto kReconMethodNames = std::to_array<Named<ReconMethod>>({
    {"adaptive", ReconMethod::adaptive},
    {"none", ReconMethod::none},
    {"gaussian", ReconMethod::gaussian},
    {"glassner", ReconMethod::glassner},
    {"marvasti", ReconMethod::marvasti},
    {"voronoi", ReconMethod::voronoi},
    {"act", ReconMethod::act},
    {"gonzato-marchand", ReconMethod::gonzatoMarchand},
});
static_assert(kReconMethodNames.size() == std::variant_size_v<ReconSettings>);
inline constexpr auto kHitReadingNames = std::to_array<Named<HitReading>>({
    {"intensities", HitReading::intensities},
    {"densities", HitReading::densities},
});
inline constexpr auto kKernelGainNames = std::to_array<Named<KernelGain>>({
    {"unit", KernelGain::unit},
    {"paper", KernelGain::paper},
});
inline constexpr auto kKernelFlowNames = std::to_array<Named<KernelFlow>>({
    {"scatter", KernelFlow::scatter},
    {"gather", KernelFlow::gather},
});
inline constexpr auto kSpectrumNames = std::to_array<Named<ContinuousSpectrum::Source>>({
    {"sun", ContinuousSpectrum::Source::extraterrestrial},
    {"sun-am1.5", ContinuousSpectrum::Source::airMass1_5},
    {"equal", ContinuousSpectrum::Source::equal},
});
inline constexpr auto kShapeNames = std::to_array<Named<ShapeName>>({
    {"prism", ShapeName::prism},
    {"pyramid", ShapeName::pyramid},
});
inline constexpr auto kOrientationNames = std::to_array<Named<OrientationName>>({
    {"random", OrientationName::random},
    {"plate", OrientationName::plate},
    {"column", OrientationName::column},
    {"parry", OrientationName::parry},
    {"lowitz", OrientationName::lowitz},
});

/// All names of the enumeration that the argument belongs to.
constexpr std::span<const Named<Engine>> namesOf(Engine) { return kEngineNames; }
constexpr std::span<const Named<PathMode>> namesOf(PathMode) { return kPathModeNames; }
constexpr std::span<const Named<Simd>> namesOf(Simd) { return kSimdNames; }
constexpr std::span<const Named<Sampler>> namesOf(Sampler) { return kSamplerNames; }
constexpr std::span<const Named<Symmetry>> namesOf(Symmetry) { return kSymmetryNames; }
constexpr std::span<const Named<ReconMethod>> namesOf(ReconMethod) { return kReconMethodNames; }
constexpr std::span<const Named<HitReading>> namesOf(HitReading) { return kHitReadingNames; }
constexpr std::span<const Named<KernelGain>> namesOf(KernelGain) { return kKernelGainNames; }
constexpr std::span<const Named<KernelFlow>> namesOf(KernelFlow) { return kKernelFlowNames; }
std::span<const Named<Projection>> namesOf(Projection);  // as sky/projection.h has them
constexpr std::span<const Named<ContinuousSpectrum::Source>> namesOf(ContinuousSpectrum::Source) {
  return kSpectrumNames;
}
constexpr std::span<const Named<ShapeName>> namesOf(ShapeName) { return kShapeNames; }
constexpr std::span<const Named<OrientationName>> namesOf(OrientationName) { return kOrientationNames; }

/// The word a scene file uses for `value`.
template <class E>
constexpr std::string_view nameOf(E value) {
  for (const auto& [name, named] : namesOf(value)) {
    if (named == value) return name;
  }
  return {};
}

/// The value of a word that nameOf() has for it.
template <class E>
constexpr E valueOf(std::string_view name) {
  for (const auto& named : namesOf(E{})) {
    if (named.name == name) return named.value;
  }
  return E{};
}

/// The method that the settings are of.
constexpr ReconMethod methodOf(const ReconSettings& settings) { return static_cast<ReconMethod>(settings.index()); }

}  // namespace parhelion
