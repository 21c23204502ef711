// SPDX-License-Identifier: Apache-2.0
#include "trace/tracer.h"

#include <algorithm>
#include <stdexcept>

#include <tbb/enumerable_thread_specific.h>

#include "parallel/loops.h"
#include "parallel/run_clock.h"
#include "parallel/threads.h"

namespace parhelion {

namespace {

// A stop must wait for no more than a batch: this is long beside a wave's work and short for people.
constexpr double kBatchSeconds = 0.1;
// Bundles of the first batch, so few that it is short in any cloud, and the most that one batch may differ from the
// next: one that was slowed down by others says little.
constexpr double kFirstBatch = 32.0, kMostGrowth = 4.0;

/// What one thread keeps to itself.
struct Worker {
  std::unique_ptr<Film> film;
  std::unique_ptr<Wave> wave;
};

}  // namespace

struct Tracer::Workers {
  Threads threads;
  tbb::enumerable_thread_specific<Worker> all;
};

Tracer::Tracer(const Cloud& cloud, const TraceSettings& settings, Film& film, int threads, Simd simd)
    : cloud_(cloud),
      film_(film),
      steps_(laneSteps(simd)),
      engines_(makeIntersectors(cloud, settings.engine)),
      paths_(cloud, settings.paths, film.wantsSequences()),
      workers_(new Workers{
          Threads(threads), tbb::enumerable_thread_specific<Worker>([this, settings] {
            return Worker{film_.forThread(), std::make_unique<Wave>(cloud_, engines_, paths_, settings, steps_)};
          })}),
      batch_(kFirstBatch) {}

Tracer::~Tracer() = default;

std::uint64_t Tracer::trace(const RayRange& range, const GoOn& goOn) {
  RayRange left = range;
  while (const std::uint64_t traced = traceSome(left)) {
    left = {left.first + traced, left.count - traced};
    if (!goOn(range.count - left.count)) break;
  }
  return range.count - left.count;
}

std::uint64_t Tracer::traceSome(const RayRange& range) {
  if (range.count == 0) return 0;
  const auto size = static_cast<std::uint64_t>(cloud_.bundleSize());
  if (range.first % size != 0) throw std::invalid_argument("a range must start with the first ray of a bundle");
  const std::uint64_t whole = range.count / size, wanted = static_cast<std::uint64_t>(batch_);
  if (whole == 0) {
    // The run's last bundle is cut short; it makes a wave of its own.
    Worker& worker = workers_->all.local();
    worker.wave->trace(range.first / size, 1, static_cast<int>(range.count), *worker.film);
    return range.count;
  }
  const std::uint64_t bundles = std::min(whole, wanted);
  const RunClock clock;
  traceBundles(range.first / size, bundles);
  const double growth = std::clamp(kBatchSeconds / clock.seconds(), 1.0 / kMostGrowth, kMostGrowth);
  if (bundles == wanted) batch_ = std::max(1.0, batch_ * growth);
  return bundles * size;
}

void Tracer::traceBundles(std::uint64_t first, std::uint64_t count) {
  // Where so few bundles take so long, each thread gets its part of them.
  const auto threads = static_cast<std::uint64_t>(workers_->threads.count());
  const auto most = static_cast<std::uint64_t>(Wave::bundles(cloud_));
  const std::uint64_t waveSize = std::min(most, (count + threads - 1) / threads);
  workers_->threads.run([&] {
    forEach((count + waveSize - 1) / waveSize, [&](std::uint64_t k) {
      Worker& worker = workers_->all.local();
      const std::uint64_t own = std::min(waveSize, count - k * waveSize);
      worker.wave->trace(first + k * waveSize, static_cast<int>(own), cloud_.bundleSize(), *worker.film);
    });
  });
}

void Tracer::collect() {
  for (Worker& worker : workers_->all) {
    film_.merge(*worker.film);
    counts_.merge(worker.wave->takeCounts());
  }
}

}  // namespace parhelion
