// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "crystal/raypath/path_pattern.h"

namespace parhelion {

/// Part of the light, told apart by how it came through which crystals. What is left out takes all.
struct LayerSettings {
  /// Of a crystal's own tilt: the angle of its c axis, of Lowitz crystals of the axis through two opposite edges
  /// (crystal +y), from where it is at rest; of crystals in all orientations, of the c axis from the vertical.
  struct TiltRange {
    double from = 0.0, to = 0.0;  // rad; `to` is not in it
  };

  std::string name;
  std::optional<PathPattern> paths;
  std::vector<std::string> populations;  // by name; empty: all
  std::optional<TiltRange> tilt;
  std::optional<int> order = std::nullopt;  // how often the light was scattered in a cloud

  /// Whether light that was scattered twice or more may belong here: it has no one path, population or tilt.
  bool takesOrder(int scattered) const {
    return !paths && populations.empty() && !tilt && (!order || *order == scattered);
  }

  bool isOf(const std::string& population) const {
    return populations.empty() || std::find(populations.begin(), populations.end(), population) != populations.end();
  }
};

/// The most layers of a run: each is a bit of a word.
inline constexpr std::size_t kMostLayers = 64;

/// What a run keeps of the light, and what it tells apart.
struct PathSettings {
  std::optional<PathPattern> filter;  // only light that took such a path is kept
  std::vector<LayerSettings> layers;  // light goes to the first that takes it, and what none takes to the rest
};

}  // namespace parhelion
