// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "trace/trace_settings.h"

namespace parhelion::bench {

/// Settings that all measurements of tracing start from: every ray for itself.
constexpr TraceSettings tracing(Engine engine, PathMode path = PathMode::split, Sampler sampler = Sampler::random,
                                Symmetry symmetry = Symmetry::none) {
  return {.engine = engine, .path = path, .sampler = sampler, .symmetry = symmetry};
}

/// A way to trace that is compared with others. Charts draw one curve for each row below; their colours and dashes
/// follow from the words of the id (bench/rays_style.gp).
struct Configuration {
  std::string_view id, label;
  TraceSettings settings;  // rays and seed are set by whoever measures
};

inline constexpr std::array<Configuration, 7> kConfigurations{{
    {"embree", "Embree", tracing(Engine::embree)},
    {"embree-sobol", "Embree by Sobol' points", tracing(Engine::embree, PathMode::split, Sampler::sobol)},
    {"planes-chance", "planes by chance", tracing(Engine::planes, PathMode::chance)},
    {"planes", "planes", tracing(Engine::planes)},
    {"planes-sobol", "planes by Sobol' points", tracing(Engine::planes, PathMode::split, Sampler::sobol)},
    {"planes-mirror", "planes mirrored", tracing(Engine::planes, PathMode::split, Sampler::random, Symmetry::mirror)},
    {"planes-radial", "planes in rings", tracing(Engine::planes, PathMode::split, Sampler::random, Symmetry::radial)},
}};

}  // namespace parhelion::bench
