// SPDX-License-Identifier: Apache-2.0
#include "render/sky_sums.h"

#include <stdexcept>

#include "sky/tally_exr.h"
#include "trace/expose.h"

namespace parhelion {

Film& SkySums::film() {
  if (!film_) film_ = makeFilm(tally_, cloud_, loaded_.scene.trace.symmetry);
  return *film_;
}

void SkySums::read(const std::filesystem::path& path) {
  SkyTally held = readSkyTallyExr(path);
  if (const std::string why = objectionToAdding(held.info(), tally_.info()); !why.empty())
    throw std::invalid_argument(path.string() + " is of another run: " + why);
  // The texts of the run that goes on, not of the one that began.
  held.info().scene = tally_.info().scene;
  held.info().version = tally_.info().version;
  held.shareOrigin();
  film_.reset();
  tally_ = std::move(held);
}

void SkySums::write(const Output& file) const { writeSkyTallyExr(file, tally_); }

void SkySums::subtract(RunSums& other) {
  const SkyTally& less = dynamic_cast<SkySums&>(other).tally();
  tally_.shareOrigin();
  tally_.subtract(less);
}

}  // namespace parhelion
