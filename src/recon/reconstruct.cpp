// SPDX-License-Identifier: Apache-2.0
#include "recon/reconstruct.h"

#include "image/radiance.h"
#include "recon/adaptive.h"

namespace parhelion {

Image reconstruct(const Tally& tally, const ReconSettings& settings) {
  switch (settings.method) {
    case ReconMethod::none:
      return plainRadiance(tally);
    case ReconMethod::adaptive:
      return adaptiveRadiance(tally);
  }
  return {};
}

}  // namespace parhelion
