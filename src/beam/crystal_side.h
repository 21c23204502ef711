// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace parhelion {

/// Crystals by where their c axes point: all of them, or those alone whose upper end the light meets, or whose lower.
enum class CrystalSide { both, upper, lower };

}  // namespace parhelion
