// SPDX-License-Identifier: Apache-2.0
#include "rays_render.h"

#include "trace/sky_film.h"

namespace parhelion::bench {

Tally wholeSky(const Cloud& cloud, int side) {
  TallyInfo info;
  info.white = cloud.spectrum().white();
  info.camera.width = info.camera.height = side;
  return Tally(info, cloud.spectrum().colours());
}

RenderSpeed renderFor(double seconds, const Cloud& cloud, TraceSettings settings, int side, int threads) {
  Tally tally = wholeSky(cloud, side);
  SkyFilm film({&tally}, nullptr);
  settings.rays = kMaxRays;
  const Stopwatch watch;
  const TraceReport report =
      traceRays(cloud, settings, 0, film, {.threads = threads, .timeLimit = seconds, .onProgress = {}});
  return {report.rays, report.hits, watch.read()};
}

}  // namespace parhelion::bench
