// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "beam/band_store.h"
#include "beam/ring_integral.h"

namespace parhelion {

/// What was worked out for one picture and serves the next, of a sweep for one.
struct LightStore {
  BandStore bands;
  RingStore rings;
};

}  // namespace parhelion
