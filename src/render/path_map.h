// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scene/parse_scene.h"
#include "trace/path_ledger.h"

namespace parhelion {

/// Layers for the families of paths that make the light of a ledger: at most `most`. First come those that make a halo
/// with a name, together, if they bring a thousandth of the light; then each other class by itself; both with most
/// light first. The names of the layers say what they are.
std::vector<LayerSettings> strongestPaths(const std::vector<PathLedger::Entry>& entries, const Cloud& cloud,
                                          std::size_t most);

}  // namespace parhelion
