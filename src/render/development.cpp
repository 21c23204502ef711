// SPDX-License-Identifier: Apache-2.0
#include "render/development.h"

#include "parallel/threads.h"
#include "sky/picture_error.h"

namespace parhelion {

std::optional<double> Development::error(const std::atomic<bool>* stop) {
  Watch watch;
  watch.stop = stop;
  try {
    develop(watch);
  } catch (const ReconStopped&) {
    return {};
  }
  return pictureError(sky_->image, sums_.tally().flattened());
}

ReconstructedSky Development::take() {
  if (!sky_ || rays_ != sums_.origin().rayCount()) develop({});
  return std::move(*sky_);
}

void Development::develop(const Watch& watch) {
  sky_.reset();
  sky_ = withThreads(threads_, [&] { return reconstruct(sums_.tally(), loaded_.scene.recon, {}, watch); });
  rays_ = sums_.origin().rayCount();
}

}  // namespace parhelion
