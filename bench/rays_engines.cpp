// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "csv.h"
#include "rays_configurations.h"
#include "rays_finders.h"
#include "rays_plan.h"
#include "rays_queries.h"
#include "rays_render.h"

namespace parhelion::bench {
namespace {

constexpr int kSide = 1024;                // pixels, of the films rendered into
constexpr std::uint64_t kGrain = 1 << 14;  // paths that a thread follows at a time
constexpr int kLoopRays = 1 << 15;         // of the bare loop: they stay in the second cache
constexpr double kAspects[] = {0.01, 0.1, 1.0, 10.0, 100.0};

/// Of one finder in crystals of one aspect ratio.
struct Errors {
  std::uint64_t wrong = 0, lost = 0;
  double farthest = 0.0;  // of wrong encounters from the edge, crystal units

  void merge(const Errors& other) {
    wrong += other.wrong;
    lost += other.lost;
    farthest = std::max(farthest, other.farthest);
  }

  void count(const Crystal& crystal, const InteriorRay& ray, const std::optional<FaceHit>& hit, int exact) {
    // Embree asks the planes where it finds nothing itself.
    if (!hit || hit->rescued) {
      ++lost;
    } else if (hit->face != exact) {
      ++wrong;
      farthest = std::max(farthest, edgeDistance(crystal, ray.point, ray.lightDir, exact, hit->face));
    }
  }
};

/// Of all finders, in the order of finderKinds(), over the same queries.
struct AllErrors {
  std::uint64_t queries = 0;
  std::vector<Errors> of = std::vector<Errors>(finderKinds().size());

  AllErrors merged(const AllErrors& other) const {
    AllErrors sum = *this;
    sum.queries += other.queries;
    for (std::size_t i = 0; i < of.size(); ++i) sum.of[i].merge(other.of[i]);
    return sum;
  }
};

/// Over the interior rays of so many paths.
AllErrors countErrors(const Cloud& cloud, std::uint64_t paths) {
  const Crystal crystal = onlyCrystal(cloud);
  std::vector<Finder> finders;
  for (const FinderKind& kind : finderKinds()) finders.push_back(makeFinder(kind, cloud));
  const auto countIn = [&](const tbb::blocked_range<std::uint64_t>& range, AllErrors errors) {
    forEachInteriorRay(cloud, range.begin(), range.end(), [&](const InteriorRay& ray) {
      ++errors.queries;
      const int exact = exactNextFace(crystal, ray.point, ray.lightDir, ray.leftFace);
      for (std::size_t i = 0; i < finders.size(); ++i) {
        const auto find = [&](const auto& own) { return own.nextFace(crystal, ray.point, ray.lightDir, ray.leftFace); };
        errors.of[i].count(crystal, ray, withFinder(finders[i], find), exact);
      }
    });
    return errors;
  };
  return tbb::parallel_reduce(tbb::blocked_range<std::uint64_t>(0, paths, kGrain), AllErrors{}, countIn,
                              [](const AllErrors& a, const AllErrors& b) { return a.merged(b); });
}

/// Next faces found in a second of a bare loop over recorded rays.
double loopSpeed(const FinderKind& kind, const Cloud& cloud, double seconds) {
  const Crystal crystal = onlyCrystal(cloud);
  const std::vector<InteriorRay> rays = interiorRays(cloud, kLoopRays);
  return withFinder(makeFinder(kind, cloud), [&](const auto& finder) {
    const Stopwatch watch;
    std::uint64_t found = 0;
    double busy = 0.0;
    volatile double length = 0.0;  // keeps the loop from being left out
    for (; busy < seconds; busy = watch.read().cpuSeconds) {
      double sum = 0.0;
      for (const InteriorRay& ray : rays)
        if (const auto hit = finder.nextFace(crystal, ray.point, ray.lightDir, ray.leftFace)) {
          sum += hit->distance;
          ++found;
        }
      length = length + sum;
    }
    return static_cast<double>(found) / busy;
  });
}

}  // namespace

void measureEngines(const RaysPlan& plan) {
  const std::uint64_t paths = plan.quick ? 200'000 : 10'000'000;
  Csv csv(
      plan.results / "rays_engines.csv",
      "Hexagonal prisms in random orientation, 550 nm, point sun 20 degrees high, seed 1.\n"
      "wrong, lost: of the queries, which are the interior rays of real paths; a face is wrong where half-spaces in "
      "long double find another.\n"
      "edge_distance: the farthest that a wrong encounter was from the edge, in sides of the hexagon.\n"
      "rays_per_cpu_second: whole renders into 1024 x 1024 pixels, one thread. loop_per_cpu_second: a bare loop "
      "over recorded interior rays.",
      "engine,label,aspect,queries,wrong,lost,edge_distance,rays,hits,rays_per_cpu_second,hits_per_cpu_second,"
      "loop_per_cpu_second");
  for (const double aspect : kAspects) {
    const Cloud cloud = randomPrisms(aspect);
    const AllErrors errors = countErrors(cloud, paths);
    for (std::size_t i = 0; i < errors.of.size(); ++i) {
      const FinderKind& kind = finderKinds()[i];
      RenderSpeed render;
      if (kind.engine) render = renderFor(plan.seconds(), cloud, tracing(*kind.engine), kSide, 1);
      csv.row(kind.id, kind.label, aspect, errors.queries, errors.of[i].wrong, errors.of[i].lost, errors.of[i].farthest,
              render.rays, render.hits, render.perCpuSecond(render.rays), render.perCpuSecond(render.hits),
              loopSpeed(kind, cloud, plan.seconds() / 3.0));
    }
  }
}

}  // namespace parhelion::bench
