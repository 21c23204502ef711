// SPDX-License-Identifier: Apache-2.0
#include "cli/tally_run.h"

#include "render/empty_tally.h"
#include "trace/film.h"

namespace parhelion::cli {

TallyRun traceTally(const RunOptions& options, const LoadedScene& loaded, const Cloud& cloud, const StopSignal& stop) {
  const Scene& scene = loaded.scene;
  Scene chosen = scene;
  chosen.trace.symmetry = symmetryOf(cloud, scene.trace.symmetry);
  TallyRun run{emptyTally(loaded, cloud, PARHELION_VERSION), {}};
  const auto film = makeFilm(run.tally, cloud, chosen.trace.symmetry);
  run.result = runTrace(options, chosen, cloud, *film, stop);
  if (run.result.report.rays > 0) run.tally.info.rays = {{run.result.report.firstRay, run.result.report.rays}};
  return run;
}

ExrAttributes sceneAttributes(const LoadedScene& loaded, std::uint64_t rays) {
  return {{"software", "parhelion " PARHELION_VERSION},
          {"parhelion:version", PARHELION_VERSION},
          {"parhelion:seed", std::to_string(loaded.scene.trace.seed)},
          {"parhelion:rays", std::to_string(rays)},
          {kSceneKey, loaded.text}};
}

}  // namespace parhelion::cli
