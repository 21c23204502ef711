// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "crystal/raypath/stance.h"

namespace parhelion {

/// A halo that has a name: which raypaths make it in crystals of which stance. Where other paths make it in crystals of
/// another stance, there is one more of the same name.
struct HaloPath {
  std::string_view name;        // as observers call it, UTF-8
  std::string_view pattern;     // path_pattern.h
  std::vector<Stance> stances;  // any of them
  std::string_view source;
};

/// The halos that patterns may call by name. `source` says who treats each.
/// Where two halos come of the same paths in the same crystals, such as the upper and the lower tangent arc, both names
/// mean both.
std::span<const HaloPath> haloPaths();

/// All of this name, whatever its capitals; its plural and "deg" for the degree sign will do. Empty if there is none.
std::vector<const HaloPath*> halosNamed(std::string_view name);

/// Each name once.
std::vector<std::string_view> haloNames();

}  // namespace parhelion
