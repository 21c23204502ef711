// SPDX-License-Identifier: Apache-2.0
#include "render/sky_sums.h"

#include <stdexcept>

#include "sky/tally_exr.h"
#include "trace/expose.h"

namespace parhelion {

namespace {

/// The least that can be in the place of a tally.
Tally withoutPixels(TallyInfo info) {
  info.camera = {};
  info.camera.width = info.camera.height = 1;
  info.symmetry = TallySymmetry::none;
  return Tally(info, 1);
}

}  // namespace

Film& SkySums::film() {
  if (!film_) film_ = makeFilm(tally_, cloud_, loaded_.scene.trace.symmetry);
  return *film_;
}

void SkySums::read(const std::filesystem::path& path) {
  TallyInfo own = tally_.info();
  own.rays.clear();
  film_.reset();
  // The room of these sums is for those of the file.
  tally_ = SkyTally(withoutPixels(own));
  try {
    if (const std::string why = objectionToAdding(readTallyInfo(path), own); !why.empty())
      throw std::invalid_argument(path.string() + " is of another run: " + why);
    tally_ = readSkyTallyExr(path);
  } catch (...) {
    tally_ = emptyTally(loaded_, cloud_);
    throw;
  }
  // The texts of the run that goes on, not of the one that began.
  tally_.info().scene = own.scene;
  tally_.info().version = own.version;
  tally_.shareOrigin();
}

void SkySums::write(const Output& file) const { writeSkyTallyExr(file, tally_); }

void SkySums::subtract(RunSums& other) {
  const SkyTally& less = dynamic_cast<SkySums&>(other).tally();
  tally_.shareOrigin();
  tally_.subtract(less);
}

}  // namespace parhelion
