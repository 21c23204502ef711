// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>

#include "band_limited_field.h"

namespace parhelion {
namespace {

constexpr std::array<int, 4> kSteps{1, 3, 10, 30};
using Errors = std::array<double, 4>;  // rms error relative to the field's rms, after so many steps
using Method = std::function<Reconstruction(const Recovery&, int steps)>;

const Method kMarvastiPlain = [](const Recovery& r, int steps) { return r.marvasti(steps, 1.0); };
const Method kMarvastiFast = [](const Recovery& r, int steps) { return r.marvasti(steps, 1.0 / r.density()); };
const Method kVoronoi = [](const Recovery& r, int steps) { return r.voronoi(steps); };
const Method kAct = [](const Recovery& r, int steps) { return r.act(steps); };

/// Eight fields of degree 8 on a torus of 128 x 128 pixels, with samplings whose largest gap (pixels) is as wanted.
template <class Known>
std::vector<Recovery> recoveries(const Known& known, double gapFrom = 0.0, double gapTo = 128.0) {
  std::vector<Recovery> found;
  for (std::uint64_t seed = 1; found.size() < 8; ++seed) {
    const HitMap torus = sampledTorus(128, 128, seed, known);
    const double gap = largestGap(torus, NearestHits(torus));
    if (gap >= gapFrom && gap <= gapTo) found.emplace_back(trigonometricField(128, 128, 8.0, seed), torus, 8.0);
  }
  return found;
}

constexpr double kRounding = 2e-15;  // of the rms error: below it errors are equal

struct Moments {
  int count = 0;
  double mean = 0.0, deviation = 0.0;
};

/// Mean and standard deviation of the logarithm of the samplings' errors after so many steps, without those for which
/// the iteration was stopped.
Moments logErrors(const std::vector<Recovery>& samplings, const Method& method, int steps) {
  Moments moments;
  double sum = 0.0, squares = 0.0;
  for (const Recovery& sampling : samplings) {
    const Reconstruction result = method(sampling, steps);
    if (!result.remarks.empty()) continue;
    const double logError = std::log(std::max(sampling.error(result), kRounding));
    sum += logError;
    squares += logError * logError;
    ++moments.count;
  }
  const double n = moments.count;
  moments.mean = sum / n;
  moments.deviation = std::sqrt(std::max(squares - sum * sum / n, 0.0) / (n - 1.0));
  return moments;
}

/// The errors printed for one sampling against those of eight drawn in the same way: within 20 % of their (logarithmic)
/// mean, or within 3 of their standard deviations where samplings differ more: one draw in fifty is farther out, and
/// the four cells of a row go together. No more than `stopped` of the eight may be stopped.
void checkAgainst(const std::vector<Recovery>& samplings, const Method& method, const Errors& printed,
                  int stopped = 0) {
  for (std::size_t i = 0; i < kSteps.size(); ++i) {
    const Moments ours = logErrors(samplings, method, kSteps[i]);
    CAPTURE(kSteps[i]);
    CAPTURE(std::exp(ours.mean));
    CAPTURE(std::exp(ours.deviation));
    CHECK(ours.count >= static_cast<int>(samplings.size()) - stopped);
    const double excess = ours.mean - std::log(std::max(printed[i], kRounding));
    const double bound = std::max(std::log(1.2), 3.0 * ours.deviation);
    // Below 1e-6 the last digits are those of rounding and of when a program stops: smaller is as good.
    if (printed[i] > 1e-6) CHECK(excess > -bound);
    CHECK(excess < bound);
  }
}

/// After 30 steps the method must say that its residual grew, and hold a picture not worse than that of its first.
void checkStopped(const std::vector<Recovery>& samplings, const Method& method) {
  for (const Recovery& sampling : samplings) {
    const Reconstruction result = method(sampling, 30);
    REQUIRE(result.remarks.size() == 1);
    CAPTURE(result.remarks[0]);
    CHECK(result.remarks[0].find("the residual grew from") != std::string::npos);
    CHECK(sampling.error(result) < 1.1 * sampling.error(method(sampling, 1)));
  }
}

}  // namespace

TEST_CASE("a band-limited field comes back from 10 % of its pixels as fast as the literature's methods recover it") {
  const auto samplings = recoveries([](int, int, double r) { return r < 0.10; }, 5.05, 5.15);
  checkAgainst(samplings, kMarvastiPlain, {0.90, 0.73, 0.37, 0.074});
  // It converges where no wave has more than twice its share of the samples, as not every draw of 10 % grants.
  checkAgainst(samplings, kMarvastiFast, {0.29, 0.069, 0.0044, 2.5e-5}, 1);
  checkAgainst(samplings, kVoronoi, {0.10, 0.0040, 3e-7, 4e-16});
  checkAgainst(samplings, kAct, {0.12, 0.0043, 3e-8, 9e-9});
}

TEST_CASE("a field known at 3 % of its pixels comes back slowly, and the fast Marvasti iteration is stopped") {
  const auto samplings = recoveries([](int, int, double r) { return r < 0.03; }, 9.8, 10.3);
  checkAgainst(samplings, kMarvastiPlain, {0.97, 0.91, 0.75, 0.50});
  checkAgainst(samplings, kVoronoi, {0.36, 0.15, 0.031, 0.0023});
  checkAgainst(samplings, kAct, {0.45, 0.17, 0.013, 2e-5});
  checkStopped(samplings, kMarvastiFast);
}

TEST_CASE("where one half of a field is dense and the other sparse the fast Marvasti iteration is stopped") {
  const auto samplings = recoveries([](int x, int, double r) { return r < (x < 64 ? 0.30 : 0.02); });
  checkAgainst(samplings, kMarvastiPlain, {0.85, 0.69, 0.51, 0.35});
  checkAgainst(samplings, kVoronoi, {0.33, 0.16, 0.051, 0.011});
  checkAgainst(samplings, kAct, {0.38, 0.21, 0.020, 2e-4});
  checkStopped(samplings, kMarvastiFast);
}

TEST_CASE("a hole of four Nyquist periods in a well-sampled field closes slowly") {
  const auto samplings = recoveries([](int x, int y, double r) {
    const bool hole = x >= 48 && x < 80 && y >= 48 && y < 80;
    return r < 0.20 && !hole;
  });
  checkAgainst(samplings, kMarvastiPlain, {0.82, 0.57, 0.25, 0.17});
  checkAgainst(samplings, kMarvastiFast, {0.33, 0.19, 0.15, 0.11});
  checkAgainst(samplings, kVoronoi, {0.31, 0.25, 0.14, 0.025});
  checkAgainst(samplings, kAct, {0.32, 0.17, 0.11, 2e-4});
}

TEST_CASE("66 samples do not determine 197 unknowns, and no method pretends so") {
  const auto samplings = recoveries([](int, int, double r) { return r < 0.004; });
  for (const Recovery& sampling : samplings) {
    CHECK(sampling.error(sampling.marvasti(1, 1.0)) == doctest::Approx(0.99).epsilon(0.02));
    CHECK(sampling.error(sampling.marvasti(30, 1.0)) == doctest::Approx(0.92).epsilon(0.2));
    CHECK(sampling.error(sampling.voronoi(30)) == doctest::Approx(1.04).epsilon(0.2));
    CHECK(sampling.error(sampling.act(30)) == doctest::Approx(0.79).epsilon(0.2));
  }
  checkStopped(samplings, kMarvastiFast);
}

TEST_CASE("a signal of degree 8 known at a fifth of 256 samples: Voronoi and ACT find it, Marvasti falls slowly") {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const Recovery signal(trigonometricField(256, 1, 16.0, seed),
                          sampledTorus(256, 1, seed, [](int, int, double r) { return r < 0.20; }), 16.0);
    CAPTURE(largestGap(signal.map, signal.nearest));
    CHECK(signal.error(signal.voronoi(30)) < 1e-6);
    CHECK(signal.error(signal.act(30)) < 1e-6);
    const double first = signal.error(signal.marvasti(1, 1.0)), last = signal.error(signal.marvasti(30, 1.0));
    CHECK(first == doctest::Approx(0.8).epsilon(0.1));  // a fifth of the signal
    CHECK(last > 1e-3);
    CHECK(last < 0.5 * first);
  }
}

}  // namespace parhelion
