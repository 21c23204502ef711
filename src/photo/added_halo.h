// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "photo/halo_lookup.h"
#include "photo/sky_mask.h"
#include "picture/photograph.h"

namespace parhelion {

/// The halo as light in a photograph: what one unit of the halo's radiance adds to the linear samples of a pixel that
/// is all sky.
struct AddedHalo {
  const HaloLookup& halo;
  const SkyMask& mask;
  Vec3 perRadiance{1.0};  // R, G, B; linear samples (white is 1) per 1/sr

  /// What is added to a pixel, linear; none where there is no sky or no halo to be looked up.
  std::optional<Vec3> at(int x, int y) const;
};

struct AddedHaloReport {
  std::size_t touched = 0;    // pixels whose samples changed
  std::size_t clipped = 0;    // pixels that the halo brought beyond white
  std::size_t uncovered = 0;  // pixels of sky that the halo's picture does not reach; nothing was added there

  AddedHaloReport& operator+=(const AddedHaloReport& other);
};

/// Adds the halo's light to a photograph, in linear light. Each sample becomes one of the two codes next to its light,
/// by chance in proportion (the same for the same pixel), so that areas have the right light to much less than a code;
/// floats become the sum itself. Samples of pixels without sky or without halo stay as they are, bit for bit, and so
/// does alpha. The same bits for any number of threads. Throws std::invalid_argument unless the mask has the
/// photograph's size.
AddedHaloReport addHalo(Photograph& photograph, const AddedHalo& added);

}  // namespace parhelion
