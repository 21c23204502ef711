// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace parhelion {

/// What an EXR file says of itself by the standard attribute `envmap`.
enum class Envmap { none, latLong };

}  // namespace parhelion
