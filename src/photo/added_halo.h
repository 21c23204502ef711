// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "photo/halo_lookup.h"
#include "photo/sky_mask.h"
#include "picture/photograph.h"

namespace parhelion {

/// The halo as light in a photograph: where it is, how much sky a pixel shows, and how bright it is there.
struct AddedHalo {
  const HaloLookup& halo;
  const SkyMask& mask;
  Vec3 perRadiance{1.0};  // R, G, B; what a radiance of 1/sr adds to linear samples (white is 1) where all is sky

  /// The linear light that is added to a pixel; none where the lens shows no sky or the halo's picture does not reach.
  std::optional<Vec3> at(int x, int y) const;
};

struct AddedHaloReport {
  std::size_t touched = 0;    // pixels whose samples changed
  std::size_t clipped = 0;    // pixels that the halo would make brighter than white
  std::size_t uncovered = 0;  // pixels of sky that the halo's picture does not reach; nothing was added there
};

/// Adds the halo's light to a photograph, in linear light.
///
/// Samples of 8 and 16 bits are dithered: a sample becomes one of the two codes next to its light, by chance in
/// proportion to how near they are. So the mean of an area is right to much less than a code. The choice is always the
/// same for the same pixel. Floats become the sum itself.
///
/// Alpha and the samples of pixels without sky or without halo stay as they are, bit for bit. The result has the same
/// bits for any number of threads. Throws std::invalid_argument unless the mask has the photograph's size.
AddedHaloReport addHalo(Photograph& photograph, const AddedHalo& added);

}  // namespace parhelion
