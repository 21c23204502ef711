// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/scene.h"

namespace parhelion {

/// A summary for people, angles in degrees: one line a population and one for each other part of the scene.
std::string describeScene(const Scene& scene);

}  // namespace parhelion
