// SPDX-License-Identifier: Apache-2.0
#include "traced_tally.h"

#include <cstdio>

#include "sky/tally_exr.h"

namespace parhelion::bench {

TracedSky tracePlainly(LoadedScene loaded) {
  loaded.scene.trace.symmetry = Symmetry::none;
  return traceSky(loaded, cloudOf(loaded.scene));
}

Tally keptTally(const std::filesystem::path& path, const LoadedScene& loaded) {
  if (std::filesystem::exists(path)) {
    Tally tally = readTallyExr(path);
    if (tally.info.scene == loaded.text && tally.info.version == PARHELION_VERSION) return tally;
  }
  std::fprintf(stderr, "tracing %llu rays: %s\n", static_cast<unsigned long long>(loaded.scene.trace.rays),
               path.stem().c_str());
  Tally tally = tracePlainly(loaded).tally.flattened();
  writeTallyExr(path, tally);
  return tally;
}

}  // namespace parhelion::bench
