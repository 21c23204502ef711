// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/parse_scene.h"

namespace parhelion::test {

// A complete scene, as the documentation shows it.
inline constexpr std::string_view kExample = R"(#:schema ../docs/scene.schema.json
# Parhelia at ±24.6° and the circumzenithal arc at 65.9° elevation.

[sun]
elevation = 20.0
diameter  = 0.533            # 0: a point sun
spectrum  = "sun"            # "sun" (extraterrestrial), "sun-am1.5", "equal", a wavelength 550.0, or a list
visible   = false            # draw the undeviated light (with its disc) into the image

[ice]
index = "warren-brandt"      # or a number, the same at every wavelength

[[population]]
name        = "plates"
weight      = 0.6            # share of all crystal surface; light intercepted = weight × mean projected area
shape       = "prism"
aspect      = 0.1            # length / (2 × hexagon side)
orientation = "plate"        # "random", "plate", "column", "parry", "lowitz"
tilt        = 1.0            # spread of the c axis about its rest

[[population]]
name        = "free"
weight      = 0.4
shape       = "prism"
aspect      = 2.0
orientation = { zenith = 90.0, azimuth = { uniform = [0, 360] }, roll = { normal = [0, 5] } }

[camera]
projection     = "fisheye-equal-area"
azimuth        = 0.0                    # of the optical axis, from the sun
elevation      = 90.0
roll           = 0.0
fov_horizontal = 180.0                  # or fov_vertical, fov_diagonal
resolution     = [1024, 1024]

[trace]
rays   = "10M"               # incident rays, all wavelengths together
seed   = 1
engine = "embree"

[recon]
method = "adaptive"
)";

inline constexpr std::string_view kPopulation = "[[population]]\n";

/// The scene of a text that has at least one population.
inline Scene sceneOf(std::string_view text, const std::vector<std::string>& overrides = {}) {
  return parseScene(text, "x.toml", overrides).scene;
}

/// The scene of these tables and one population with nothing but defaults.
inline Scene sceneWith(const std::string& tables) { return sceneOf(tables + '\n' + std::string(kPopulation)); }

/// The scene's only population with these keys.
inline PopulationSettings populationWith(const std::string& keys) {
  return sceneOf(std::string(kPopulation) + keys).populations.at(0);
}

/// What is wrong with a scene; empty where nothing is.
inline std::vector<Diagnostic> errorsWith(std::string_view text, const std::vector<SceneOverride>& overrides) {
  try {
    parseScene(text, "x.toml", overrides);
  } catch (const SceneError& e) {
    return e.diagnostics();
  }
  return {};
}
inline std::vector<Diagnostic> errorsOf(std::string_view text, const std::vector<std::string>& overrides = {}) {
  return errorsWith(text, overridesOf(overrides));
}

/// "line:column message" of each error, the form in which tests state them.
inline std::vector<std::string> linesOf(const std::vector<Diagnostic>& errors) {
  std::vector<std::string> lines;
  for (const Diagnostic& d : errors) {
    lines.push_back(std::to_string(d.line) + ':' + std::to_string(d.column) + ' ' + d.message);
  }
  return lines;
}

}  // namespace parhelion::test
