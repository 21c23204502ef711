// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "photo/sky_mask.h"
#include "sky/camera_settings.h"

namespace parhelion {

/// Takes out what lies so far below the horizon that a camera pointed a little amiss does not explain it: no sky, but
/// water or snow in its colours.
void cutBelowHorizon(SkyMask& mask, const CameraSettings& camera);

/// Writes a mask that was found, with a sum over its pixels by which requireUnchangedMask() knows it again.
void writeFoundMask(const Output& output, const SkyMask& mask, const std::string& software);

/// Throws std::runtime_error if there is a file of that name that is no mask as writeFoundMask() left it: somebody has
/// corrected it, and it must not be written over.
void requireUnchangedMask(const std::filesystem::path& path);

}  // namespace parhelion
