// SPDX-License-Identifier: Apache-2.0
// Runs with pauses, against a tracer that only counts.
#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "render/tracing_run.h"
#include "render/wanted_rays.h"

using namespace parhelion;

namespace {

/// Takes part in no tracing; knows whether its result is made.
class CountingFilm : public Film {
 public:
  explicit CountingFilm(bool isFinished = false) : finished(isFinished) {}
  int add(const TracedRays&) override { return 0; }
  std::unique_ptr<Film> forThread() override { return std::make_unique<CountingFilm>(); }
  void merge(Film&) override {}
  void finish() override {
    CHECK_FALSE(finished);
    finished = true;
  }
  void reopen() override {
    CHECK(finished);
    finished = false;
  }
  double fullness() const override { return perRay * static_cast<double>(rays); }

  bool finished;
  std::uint64_t rays = 0;
  double perRay = 0.0;
};

class CountingTracer : public RayTracer {
 public:
  explicit CountingTracer(CountingFilm& film, std::uint64_t batch = 50'000) : film_(film), batch_(batch) {}
  std::uint64_t trace(const RayRange& range, const GoOn& goOn) override {
    CHECK_FALSE(film_.finished);
    std::uint64_t traced = 0;
    while (traced < range.count) {
      traced = std::min(range.count, traced + batch_);
      if (!goOn(traced)) break;
    }
    counts_.rays += traced;
    return traced;
  }
  void collect() override { film_.rays = counts_.rays; }
  const TraceCounts& counts() const override { return counts_; }
  int simdLanes() const override { return 1; }

 private:
  CountingFilm& film_;
  std::uint64_t batch_;
  TraceCounts counts_;
};

struct Outcome {
  RunReport report;
  RayRanges held;
  std::vector<std::uint64_t> measuredAt;
};

/// A run towards an error that is 1 / sqrt(rays).
Outcome runTo(double goal, RayRanges held, std::uint64_t rays, int bundle, const std::atomic<bool>* stop = nullptr) {
  CountingFilm film(!held.empty());
  CountingTracer tracer(film);
  Outcome outcome{{}, std::move(held), {}};
  RunControl control;
  control.stop = stop;
  control.goal = {goal, [&] {
                    CHECK(film.finished);
                    outcome.measuredAt.push_back(countOf(outcome.held));
                    return std::optional(1.0 / std::sqrt(static_cast<double>(countOf(outcome.held))));
                  }};
  outcome.report = traceRun(tracer, film, outcome.held, raysWithout({{0, rays}}, outcome.held), bundle, control);
  CHECK(film.finished);
  return outcome;
}

}  // namespace

TEST_CASE(
    "errors are measured after fixed numbers of whole bundles, each at most half as many again as the one before") {
  CHECK(nextErrorCheck(0, 1) == 100'000);
  CHECK(nextErrorCheck(100'000, 1) == 150'000);
  CHECK(nextErrorCheck(150'000, 1) == 200'000);
  CHECK(nextErrorCheck(0, 7) == 99'995);
  CHECK(nextErrorCheck(99'995, 7) == 149'996);
  CHECK(nextErrorCheck(0, 300'000) == 300'000);
}

TEST_CASE("a run stops at the first check where the error is small enough, broken off before or not") {
  // 1 / sqrt(n) is below 0.002 from 250k rays on.
  const Outcome whole = runTo(0.002, {}, 10'000'000, 7);
  CHECK(whole.report.end == RunEnd::goodEnough);
  CHECK(whole.held == RayRanges{{0, 299'999 / 7 * 7}});
  CHECK(whole.report.error == doctest::Approx(0.002).epsilon(0.1).scale(0));
  for (const std::uint64_t broken : {70'000u, 99'995u, 140'000u, 200'004u / 7 * 7, 259'000u}) {
    const Outcome resumed = runTo(0.002, {{0, broken}}, 10'000'000, 7);
    CHECK(resumed.held == whole.held);
    CHECK(resumed.report.end == RunEnd::goodEnough);
  }
  // The picture that was good enough stays as it is.
  const Outcome again = runTo(0.002, whole.held, 10'000'000, 7);
  CHECK(again.held == whole.held);
  CHECK(again.report.rays == 0);
  // Rays before and behind a gap say nothing until the gap is closed.
  const Outcome holes = runTo(0.002, {{70'000, 70'000}}, 10'000'000, 7);
  CHECK(holes.held == whole.held);
}

TEST_CASE("checks that cannot but fail are left out") {
  // 0.00316 after the first 100k rays: 3.2 times the goal, which needs a million.
  const Outcome outcome = runTo(0.001, {}, 10'000'000, 1);
  CHECK(outcome.held == RayRanges{{0, 1'200'000}});
  CHECK(outcome.measuredAt == std::vector<std::uint64_t>{100'000, 400'000, 800'000, 1'200'000});
}

TEST_CASE("a run that cannot reach its error traces all rays and says what was reached") {
  const Outcome outcome = runTo(0.0005, {}, 1'000'001, 1);
  CHECK(outcome.report.end == RunEnd::complete);
  CHECK(outcome.held == RayRanges{{0, 1'000'001}});
  CHECK(outcome.report.error == doctest::Approx(0.001).epsilon(1e-3).scale(0));
  CHECK(outcome.measuredAt.back() == 1'000'001);
  CHECK(runTo(0.0005, {}, 5'000'000, 1).report.end == RunEnd::goodEnough);
  const std::atomic<bool> stop{true};
  CHECK(runTo(0.0005, {}, 5'000'000, 1, &stop).report.end == RunEnd::stopped);
}

TEST_CASE("checkpoints have finished sums and right ranges, and are written when asked for") {
  CountingFilm film;
  CountingTracer tracer(film);
  RayRanges held;
  int asked = 0, written = 0;
  RunControl control;
  control.checkpoints.interval = std::numeric_limits<double>::infinity();
  control.checkpoints.requested = [&] { return ++asked == 3 || asked == 5; };
  control.checkpoints.write = [&] {
    ++written;
    CHECK(film.finished);
    CHECK(film.rays == countOf(held));
    CHECK(held == RayRanges{{100'000, static_cast<std::uint64_t>(asked) * 50'000}});
  };
  CHECK(traceRun(tracer, film, held, {{100'000, 1'000'000}}, 1, control).end == RunEnd::complete);
  CHECK(written == 2);
  CHECK(held == RayRanges{{100'000, 1'000'000}});
  control.checkpoints = {[&] { ++written; }, 0.0, [] { return false; }};
  traceRun(tracer, film, held, {{1'100'000, 200'000}}, 1, control);
  CHECK(written == 2 + 3);  // after each batch but the last
}

TEST_CASE("light that will not fit is foreseen early in the run") {
  CountingFilm film;
  CountingTracer tracer(film, 1'000'000);
  RayRanges held;
  film.perRay = 1e-12;
  CHECK_THROWS_AS(traceRun(tracer, film, held, {{0, 2'000'000'000'000}}, 1, {}), std::overflow_error);
  CHECK(countOf(held) == 1 << 24);
  CountingFilm roomy;
  roomy.perRay = 1e-14;
  CountingTracer other(roomy, 1'000'000);
  held.clear();
  CHECK(traceRun(other, roomy, held, {{0, 100'000'000}}, 1, {}).end == RunEnd::complete);
}

TEST_CASE("slices are whole bundles, take turns without gaps and are equal to one bundle") {
  for (const std::uint64_t rays : {1u, 100u, 1'000'001u}) {
    for (const std::uint64_t count : {1u, 3u, 64u, 200u}) {
      std::uint64_t next = 0, least = rays, most = 0;
      for (std::uint64_t i = 1; i <= count; ++i) {
        const RayRange slice = sliceOf(rays, 3, i, count);
        CHECK(slice.first == next);
        if (slice.count > 0) CHECK(slice.first % 3 == 0);
        next = slice.end();
        least = std::min(least, slice.count);
        most = std::max(most, slice.count);
      }
      CHECK(next == rays);
      CHECK(most - least <= 5);
    }
  }
  CHECK(sliceOf(1'000'000'000'000'000, 1, 1'000'000'000, 1'000'000'000) == RayRange{999'999'999'000'000, 1'000'000});
  CHECK_NOTHROW(requireBundleStart({6, 1}, 3));
  CHECK_THROWS_WITH_AS(requireBundleStart({7, 1}, 3), doctest::Contains("6 or 9"), std::invalid_argument);
}
