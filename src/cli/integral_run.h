// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "render/engine_choice.h"
#include "render/mixed_sky.h"
#include "scene/scene.h"

namespace parhelion::cli {

// What commands have in common that integrate light instead of following rays.

/// Whether a scene's picture is integrated, all of it or in part.
bool isIntegrated(const Scene& scene);

/// Throws Unfit if it cannot be as its engine has it.
void requireIntegrable(const Scene& scene);

/// The error that a picture is integrated to: as --error has it, or 2 %.
double integralGoal(const std::string& error);

/// Whether a command may choose what makes its light: an error is asked for, and nothing about rays.
bool asksForErrorAlone(const CLI::App& command);

/// Which options of rays mean something to a run: none; the seed, of its own points; all but those about how rays are
/// kept and continued.
enum class RayOptions { none, seed, someRays };

/// Throws Unfit if another option was given that is about rays.
void refuseRayOptions(const CLI::App& command, RayOptions taken = RayOptions::none);

/// The figures of a run by the names that runs of rays have for them. `cutOff`: share of the light that was given up.
nlohmann::ordered_json integralStats(double seconds, int threads, double cutOff);

/// Why rays were chosen, on stderr; the forecasts that a choice was made by, for --stats.
void reportChoice(const EngineChoice& choice);
nlohmann::ordered_json choiceStats(const EngineChoice& choice);

/// What a run did that made a sky without rays, or with rays for some populations alone: on stderr, and for --stats.
void reportSmooth(const MixedSky& made);
nlohmann::ordered_json smoothStats(const MixedSky& made, double seconds, int threads, Engine engine);

}  // namespace parhelion::cli
