// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace parhelion::cli {

// What commands have in common that integrate light instead of following rays.

/// Throws Unfit if an option was given that is about rays.
void refuseRayOptions(const CLI::App& command);

/// The figures of a run by the names that runs of rays have for them. `cutOff`: share of the light that was given up.
nlohmann::ordered_json integralStats(double seconds, int threads, double cutOff);

}  // namespace parhelion::cli
