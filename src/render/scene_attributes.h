// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "picture/exr.h"
#include "scene/parse_scene.h"

namespace parhelion {

/// What our pictures say made them.
inline constexpr const char* kSoftware = "parhelion " PARHELION_VERSION;

/// Under these our pictures carry the scene they were made from and, photographs with a halo in them, its strength.
inline constexpr const char* kSceneKey = "parhelion:scene";
inline constexpr const char* kStrengthKey = "parhelion:strength";

/// Pictures that were integrated say to which error.
inline constexpr const char* kErrorKey = "parhelion:error";

/// Tallies alone have this attribute.
inline constexpr const char* kTallyKey = "parhelion:tally";

/// Under this an EXR of ours says that colours outside Rec.709 have been changed, and how (picture/gamut.h).
inline constexpr const char* kGamutKey = "parhelion:gamut";

/// What every EXR of ours says about itself: the program, and the scene with which it can be made again.
ExrAttributes sceneAttributes(const LoadedScene& loaded, std::uint64_t rays);

}  // namespace parhelion
