// SPDX-License-Identifier: Apache-2.0
// Sobol' points in place of random numbers: the same expectation, less scatter.
#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "skies.h"
#include "trace/scatter_profile.h"
#include "trace/sky_map.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

/// All that a run's expectation may be looked for in: profile, map of the sky, and light by population.
struct Estimate : Film {
  ScatterProfile profile{90, 0.0, kPi};
  SkyMap map{skyDirection(0.0, radians(20.0)), 6};
  std::map<const CrystalMesh*, ExactSum> weight;  // of each population
  ExactSum squaredWeight;

  int add(const TracedRays& traced) override {
    for (int place = 0; place < traced.queue.count; ++place) {
      const double w = traced.queue.weight[place];
      weight[&traced.mesh].add(w);
      squaredWeight.add(w * w);
    }
    profile.add(traced);
    return map.add(traced);
  }
  std::unique_ptr<Film> forThread() override { return std::make_unique<Estimate>(); }
  void merge(Film& fromThread) override {
    auto& other = dynamic_cast<Estimate&>(fromThread);
    profile.merge(other.profile);
    map.merge(other.map);
    for (const auto& [mesh, sum] : other.weight) weight[mesh].merge(sum);
    squaredWeight.merge(other.squaredWeight);
  }
};

/// The figures of one run.
struct Figures {
  std::vector<double> profile, sky, shares;  // light in bins of 2 degrees, in blocks of 30, by population
  double g, meanProjectedArea, meanWeight, weightVariance;
};

Figures figuresOf(const Cloud& cloud, Sampler sampler, std::uint64_t rays, std::uint64_t seed) {
  Estimate estimate;
  const TraceReport report = traceRays(cloud, {.rays = rays, .seed = seed, .sampler = sampler}, 0, estimate);
  CHECK(report.rays == rays);
  CHECK(std::abs(report.energy.imbalance()) < 1e-12);
  Figures figures;
  for (const auto& bin : estimate.profile.bins()) figures.profile.push_back(bin.energy);
  for (int row = 0; row < estimate.map.rows(); ++row)
    for (int column = 0; column < estimate.map.columns(); ++column)
      figures.sky.push_back(estimate.map.energy(column, row));
  double total = 0.0;
  for (const auto& [mesh, sum] : estimate.weight) total += sum.value();
  for (const Population& population : cloud.populations())
    figures.shares.push_back(estimate.weight[&population.mesh()].value() / total);
  const auto summary = estimate.profile.summary();
  figures.g = summary.g;
  figures.meanProjectedArea = summary.meanProjectedArea;
  const double bundles = static_cast<double>(rays) / cloud.bundleSize();
  figures.meanWeight = total / bundles;
  figures.weightVariance = estimate.squaredWeight.value() / bundles - figures.meanWeight * figures.meanWeight;
  return figures;
}

/// Mean and scatter of the figures of runs that differ in their seed alone.
struct Runs {
  std::vector<SampleMean> profile, sky, shares;
  SampleMean g, meanProjectedArea, meanWeight, weightVariance;

  Runs(const Cloud& cloud, Sampler sampler, std::uint64_t rays, int count) {
    for (int run = 0; run < count; ++run) {
      const Figures figures = figuresOf(cloud, sampler, rays, 1000 + run);
      addTo(profile, figures.profile);
      addTo(sky, figures.sky);
      addTo(shares, figures.shares);
      g.add(figures.g);
      meanProjectedArea.add(figures.meanProjectedArea);
      meanWeight.add(figures.meanWeight);
      weightVariance.add(figures.weightVariance);
    }
  }

 private:
  static void addTo(std::vector<SampleMean>& means, const std::vector<double>& values) {
    means.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) means[i].add(values[i]);
  }
};

Disagreement compare(const std::vector<SampleMean>& a, const std::vector<SampleMean>& b) {
  Disagreement sum;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum.add(a[i].mean(), a[i].standardError(), b[i].mean(), b[i].standardError());
  return sum;
}

/// Several populations, spread in aspect and tilt, under a sun with a disc: all that there is to draw is in use.
Cloud manyKinds(const SpectrumSettings& spectrum) {
  PopulationSettings columns = prismPopulation(1.0, AxisOrientation{Normal{0.5 * kPi, radians(3.0)}});
  columns.shape = PrismSettings{UniformRange{0.5, 3.0}};
  SunSettings sun;
  sun.spectrum = spectrum;
  const std::vector populations{plates(), columns, pyramids(0.9, 0.2)};
  return Cloud(sun, PublishedIndex{}, populations);
}

/// Bundles of one, two and three rays.
const SpectrumSettings kSpectra[] = {MonochromaticSpectrum{550.0}, ContinuousSpectrum{},
                                     LineSpectrum{{450.0, 550.0, 650.0}}};

Tally exposeSobol(const Cloud& cloud, std::uint64_t firstRay, std::uint64_t endRay, int threads) {
  return traceSky(cloud, wholeSphere(), {.rays = endRay, .sampler = Sampler::sobol, .symmetry = Symmetry::mirror},
                  firstRay, threads);
}

}  // namespace

TEST_CASE("Sobol' points have the expectation of random numbers") {
  for (const SpectrumSettings& spectrum : kSpectra) {
    const Cloud cloud = manyKinds(spectrum);
    REQUIRE(cloud.bundleSize() == 1 + (&spectrum - kSpectra));
    const Runs random(cloud, Sampler::random, 20'000, 24), sobol(cloud, Sampler::sobol, 20'000, 24);
    for (const auto figures : {&Runs::profile, &Runs::sky}) {
      const Disagreement d = compare(random.*figures, sobol.*figures);
      CHECK(d.compared() > 40);
      CHECK(std::abs(d.sigmas()) < 4.0);
    }
    CHECK(sigmasApart(random.g, sobol.g) < 4.0);
    CHECK(sigmasApart(random.meanProjectedArea, sobol.meanProjectedArea) < 4.0);
    for (std::size_t p = 0; p < random.shares.size(); ++p) CHECK(sigmasApart(random.shares[p], sobol.shares[p]) < 4.0);
    // Random crystals are rejected to weigh 1, but for the few above the bound. Sobol' ones weigh what they intercept
    // against the mean of 4096 pilot crystals.
    CHECK(std::abs(random.meanWeight.mean() - 1.0) < 1e-4);
    CHECK(std::abs(sobol.meanWeight.mean() - 1.0) < 4.0 * std::sqrt(sobol.weightVariance.mean() / 4096.0));
  }
}

TEST_CASE("Sobol' points scatter hundreds of times less where chance inside the crystal has no say, and never more") {
  const Cloud cloud = manyKinds(MonochromaticSpectrum{550.0});
  constexpr int kRuns = 20;
  const Runs random(cloud, Sampler::random, 100'000, kRuns), sobol(cloud, Sampler::sobol, 100'000, kRuns);
  const auto gain = [&](int from, int to) {  // in the variance of the light between two angles, degrees
    double ofRandom = 0.0, ofSobol = 0.0;
    for (int bin = from / 2; bin < to / 2; ++bin) {
      ofRandom += random.profile[bin].variance();
      ofSobol += sobol.profile[bin].variance();
    }
    return ofRandom / ofSobol;
  };
  const double area = random.meanProjectedArea.variance() / sobol.meanProjectedArea.variance();
  const double share = random.shares[0].variance() / sobol.shares[0].variance();
  MESSAGE("variance of random numbers over that of Sobol' points: mean projected area "
          << area << ", share of a population " << share << ", mean cosine " << random.g.variance() / sobol.g.variance()
          << ", light at 22 to 50 degrees " << gain(22, 50) << ", at 60 to 120 degrees " << gain(60, 120));
  CHECK(area > 100.0);
  CHECK(share > 100.0);
  // Which way light goes in the crystal is left to chance from its second encounter on. These gains are known to 12 %
  // and, where light comes from more bins, to 8 %.
  CHECK(gain(22, 50) > 1.0);
  CHECK(gain(60, 120) > 0.8);
}

TEST_CASE("a picture by Sobol' points is the same bits for one, two and seven threads, and from parts") {
  for (const SpectrumSettings& spectrum : kSpectra) {
    const Cloud cloud = manyKinds(spectrum);
    const Tally one = exposeSobol(cloud, 0, 60'000, 1);
    CHECK(one == exposeSobol(cloud, 0, 60'000, 2));
    CHECK(one == exposeSobol(cloud, 0, 60'000, 7));
    CHECK_FALSE(one == traceSky(cloud, wholeSphere(), {.rays = 60'000, .symmetry = Symmetry::mirror}));
    Tally parts = exposeSobol(cloud, 0, 7'002, 2);
    parts.merge(exposeSobol(cloud, 25'008, 60'000, 2));
    parts.merge(exposeSobol(cloud, 7'002, 25'008, 1));
    CHECK(parts == one);
  }
}

TEST_CASE("the halves of a picture by Sobol' points are independent of each other") {
  const Cloud cloud = simpleCloud({prismPopulation(2.0)});
  const CameraSettings camera = lookAt(Projection::rectilinear, 0.0, 60.0, 0.0, 100.0, 1, 1);
  SampleMean sum, difference;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Tally tally =
        traceSky(cloud, camera, {.rays = 4096, .seed = seed, .sampler = Sampler::sobol, .symmetry = Symmetry::none});
    sum.add(tally.luminance(0));
    difference.add(2.0 * tally.firstHalf(0) - tally.luminance(0));
  }
  // Independent halves scatter alike in sum and difference: of 300 runs, the logarithm of the quotient by 0.115.
  CHECK(std::abs(std::log(sum.variance() / difference.variance())) < kSigmas * std::sqrt(4.0 / 300.0));
}
