// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "photo/added_halo.h"

namespace parhelion {

/// The light that the halo adds, linear floats.
Photograph lightForEditing(const AddedHalo& added);

/// The photograph's light and the halo's together, linear floats, beyond white where it is more.
Photograph sumForEditing(const Photograph& photograph, const AddedHalo& added);

/// What an editor's "linear dodge" (add) must lay over the encoded photograph to come to the composite: the difference
/// of the two encoded pictures in 16 bits, not below 0.
Photograph dodgeForEditing(const Photograph& photograph, const AddedHalo& added);

}  // namespace parhelion
