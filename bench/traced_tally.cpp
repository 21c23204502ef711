// SPDX-License-Identifier: Apache-2.0
#include "traced_tally.h"

#include <cstdio>
#include <utility>

#include "render/empty_tally.h"
#include "sky/tally_exr.h"
#include "trace/sky_film.h"

namespace parhelion::bench {

TracedTally traceTally(const LoadedScene& loaded, const TraceControl& control) {
  const Scene& scene = loaded.scene;
  const Cloud cloud(scene.sun, scene.ice, scene.populations);
  Tally tally = emptyTally(loaded, cloud, PARHELION_VERSION);
  SkyFilm film(tally);
  TraceReport report = traceRays(cloud, scene.trace, 0, film, control);
  tally.info.rays = {{report.firstRay, report.rays}};
  return {std::move(tally), std::move(report)};
}

Tally keptTally(const std::filesystem::path& path, const LoadedScene& loaded) {
  if (std::filesystem::exists(path)) {
    Tally tally = readTallyExr(path);
    if (tally.info.scene == loaded.text && tally.info.version == PARHELION_VERSION) return tally;
  }
  std::fprintf(stderr, "tracing %llu rays: %s\n", static_cast<unsigned long long>(loaded.scene.trace.rays),
               path.stem().c_str());
  Tally tally = traceTally(loaded).tally;
  writeTallyExr(path, tally);
  return tally;
}

}  // namespace parhelion::bench
