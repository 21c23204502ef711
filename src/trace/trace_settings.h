// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

#include "trace/path_settings.h"

namespace parhelion {

/// What finds the next face of a crystal: Embree, or the planes of a convex crystal's faces. `automatic` takes the
/// planes wherever the crystal is convex. `integral` follows no rays at all: see beam/. `mixed` does so where it can,
/// and is `automatic` for all other populations.
enum class Engine { embree, embreeRobust, planes, automatic, integral, mixed };

constexpr std::string_view nameOf(Engine value) {
  switch (value) {
    case Engine::embree:
      return "embree";
    case Engine::embreeRobust:
      return "embree-robust";
    case Engine::planes:
      return "planes";
    case Engine::automatic:
      return "auto";
    case Engine::integral:
      return "integral";
    case Engine::mixed:
      return "mixed";
  }
  return {};
}

/// What happens to light at a face: follow one branch picked by chance, or deposit what leaves and follow the rest.
enum class PathMode { split, chance };

constexpr std::string_view nameOf(PathMode value) {
  switch (value) {
    case PathMode::split:
      return "split";
    case PathMode::chance:
      return "chance";
  }
  return {};
}

/// Where the numbers come from that a ray's start is drawn from: independent ones, or Owen-scrambled Sobol' points,
/// which cover all there is to draw evenly.
enum class Sampler { random, sobol };

constexpr std::string_view nameOf(Sampler value) {
  switch (value) {
    case Sampler::random:
      return "random";
    case Sampler::sobol:
      return "sobol";
  }
  return {};
}

/// Which vector registers to use. Results are the same bits for all of them.
enum class Simd { automatic, baseline, avx2, avx512 };

constexpr std::string_view nameOf(Simd value) {
  switch (value) {
    case Simd::automatic:
      return "auto";
    case Simd::baseline:
      return "baseline";
    case Simd::avx2:
      return "avx2";
    case Simd::avx512:
      return "avx512";
  }
  return {};
}

/// What of the sky's symmetry a run makes use of. `mirror`: every ray counts as its mirror image in the vertical plane
/// through the sun, too. `radial`: light is counted by its angle from the sun alone and spread over whole rings.
/// `automatic` takes the most that the populations allow.
enum class Symmetry { automatic, none, mirror, radial };

constexpr std::string_view nameOf(Symmetry value) {
  switch (value) {
    case Symmetry::automatic:
      return "auto";
    case Symmetry::none:
      return "none";
    case Symmetry::mirror:
      return "mirror";
    case Symmetry::radial:
      return "radial";
  }
  return {};
}

/// How rays are shared out among populations. `light`: as their light is. `automatic`: more to those that make more
/// noise.
enum class Allocation { automatic, light };

constexpr std::string_view nameOf(Allocation value) {
  switch (value) {
    case Allocation::automatic:
      return "auto";
    case Allocation::light:
      return "light";
  }
  return {};
}

struct TraceSettings {
  std::uint64_t rays = 10'000'000;  // incident rays, all wavelengths together
  std::uint64_t seed = 1;
  Engine engine = Engine::automatic;
  PathMode path = PathMode::split;
  Sampler sampler = Sampler::random;
  Symmetry symmetry = Symmetry::automatic;
  PathSettings paths = {};
  Allocation allocation = Allocation::automatic;
};

/// The most rays of a run. Whether its sums will hold their light depends on how the light is spread; a run finds out
/// early (render/tracing_run.h).
inline constexpr std::uint64_t kMaxRays = 1'000'000'000'000'000;

}  // namespace parhelion
