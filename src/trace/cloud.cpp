// SPDX-License-Identifier: Apache-2.0
#include "trace/cloud.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "trace/concave_entry.h"
#include "trace/drawn_crystal.h"
#include "trace/lane_steps.h"

namespace parhelion {

namespace {

/// A number in (0, 1) for each bundle: the golden ratio's multiples fill the interval evenly over any run of
/// consecutive bundles, in integers so that no digits are lost at high indices.
double goldenQuantile(std::uint64_t seed, std::uint64_t bundle) {
  constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15;  // 2^64 / golden ratio
  const PhiloxBlock<std::uint64_t> start = philox<std::uint64_t>({}, seed);
  return toUnitInterval(fromWords(lowWord(start.b), lowWord(start.a)) + bundle * kGolden);
}

// A wave's rays: enough that making a crystal costs little beside them.
constexpr int kRaysPerShape = 1024;

/// Interceptions of so many crystals of one population, from crystal `first` on: of those that are not convex only the
/// ones of which a point was found that light meets first.
std::vector<double> pilotInterceptions(const IncidenceTable& table, const ConcaveCrystal* concave, int population,
                                       std::uint64_t first, int count) {
  std::vector<std::uint64_t> bundles(count + RayQueue::kSpare), rejected(count + RayQueue::kSpare);
  std::iota(bundles.begin(), bundles.end(), first);
  RayQueue queue(1);
  queue.makeRoom(count);
  IncidenceNumbers numbers{};
  for (int i = 0; i < count; i += IncidenceNumbers::kRoom) {
    Proposals proposals{&bundles[i], std::min(IncidenceNumbers::kRoom, count - i), rejected.data(), 0};
    laneSteps().draw(static_cast<std::uint64_t>(population), RandomPurpose::pilot, proposals.bundle, proposals.count, 0,
                     kIncidenceNumbers / 2, numbers);
    if (concave)
      proposeConcave(*concave, table, numbers, proposals, queue);
    else
      laneSteps().propose(table, numbers, proposals, queue);
  }
  return {queue.weight.begin(), queue.weight.begin() + queue.count};
}

/// The same where shapes are spread: of so many shapes.
std::vector<double> spreadInterceptions(IncidenceTable table, const Population& crystals, int population, int count) {
  constexpr int kShapes = 64;
  std::vector<double> all;
  for (int shape = 0; shape < kShapes; ++shape) {
    const DrawnCrystal drawn(crystals, 0, shape);
    table.faces = &drawn.faces;
    const int some = count / kShapes;
    const std::vector<double> own = pilotInterceptions(table, nullptr, population, std::uint64_t(shape) * some, some);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

}  // namespace

Cloud::Cloud(const SunSettings& sun, const IceSettings& ice, std::span<const PopulationSettings> populations,
             std::vector<double> favours)
    : sun_(sun),
      disc_(sun_.isPoint() ? nullptr : std::make_unique<SunDisc>(sun_.disc())),
      spectrum_(sun.spectrum),
      ice_(ice),
      populations_(populations.begin(), populations.end()),
      favours_(std::move(favours)) {
  if (favours_.empty()) favours_.assign(populations_.size(), 1.0);
  for (const PopulationSettings& own : populations) {
    optics_.push_back(crystalOptics(ice.absorbs && own.size, own.diffracts && own.size, own.distortion));
    sizes_.emplace_back();
    if (own.size) sizes_.back().emplace(*own.size, LengthLimits{kSmallestCrystal, kLargestCrystal});
  }
  std::optional<EmbreeDevice> embree;
  for (const Population& population : populations_) {
    faces_.emplace_back(population.mesh());
    concave_.emplace_back();
    spans_.emplace_back();
    if (sizes_[spans_.size() - 1]) spans_.back().emplace(population.mesh());
    if (population.mesh().isConvex()) continue;
    if (!embree) embree.emplace();
    concave_.back() = std::make_unique<ConcaveCrystal>(*embree, population.mesh());
  }
  // Any bound gives the right distribution; one that the pilot sample never exceeds wastes few proposals and leaves
  // nearly all rays with weight 1. Where no crystal is rejected, the mean makes weights that are 1 on average.
  constexpr int kPilot = 4096;
  std::vector<double> highest, mean;
  for (int p = 0; p < static_cast<int>(populations_.size()); ++p) {
    IncidenceTable table = incidence(p, Sampler::sobol);
    table.bound = 1.0;  // so that weights are interceptions
    const bool isSpread = populations_[p].isSpread();
    hasSpreadShapes_ |= isSpread;
    const std::vector<double> pilot = isSpread ? spreadInterceptions(table, populations_[p], p, kPilot)
                                               : pilotInterceptions(table, concave(p), p, 0, kPilot);
    mean.push_back(std::accumulate(pilot.begin(), pilot.end(), 0.0) / kPilot);
    highest.push_back(isSpread ? mean.back() : *std::ranges::max_element(pilot));
  }
  addPilot(pilot_[static_cast<int>(Sampler::random)], highest);
  addPilot(pilot_[static_cast<int>(Sampler::sobol)], mean);
  shareOut(mean);
}

/// Finds what rays weigh, so that they do 1 on average.
void Cloud::shareOut(const std::vector<double>& meanInterceptions) {
  double light = 0.0, rays = 0.0;
  for (std::size_t p = 0; p < populations_.size(); ++p) {
    lightShares_.push_back(populations_[p].weight() * meanInterceptions[p]);
    light += lightShares_.back();
    rays += lightShares_.back() * favours_[p];
  }
  const bool isPlain = std::ranges::all_of(favours_, [](double favour) { return favour == 1.0; });
  for (std::size_t p = 0; p < populations_.size(); ++p) {
    lightPerRay_.push_back(isPlain ? 1.0 : rays / (light * favours_[p]));
    lightShares_[p] /= light;
  }
}

void Cloud::addPilot(Pilot& pilot, const std::vector<double>& bounds) const {
  double total = 0.0;
  for (std::size_t p = 0; p < populations_.size(); ++p) {
    pilot.bound.push_back(bounds[p]);
    total += populations_[p].weight() * bounds[p] * favours_[p];
    pilot.cumulative.push_back(total);
  }
  if (!(total > 0.0)) throw std::invalid_argument("no population has any weight");
  for (double& c : pilot.cumulative) c /= total;
}

IncidenceTable Cloud::incidence(int population, Sampler sampler) const {
  const Vec3& toSun = sun_.toCentre();
  const Pilot& pilot = pilot_[static_cast<int>(sampler)];
  const double bound = pilot.bound.empty() ? 1.0 : pilot.bound[population];
  return {populations_[population].orientationQuantile(),
          populations_[population].stretch(),
          &faces_[population],
          {toSun.x, toSun.y, toSun.z},
          disc_.get(),
          bound,
          sampler == Sampler::random && !populations_[population].isSpread(),
          lightPerRay_.empty() ? 1.0 : lightPerRay_[population]};
}

void Cloud::putOptics(int population, const std::optional<CrystalSpan>& span, std::uint64_t seed,
                      RayQueue& queue) const {
  const std::size_t rays = static_cast<std::size_t>(queue.room) * static_cast<std::size_t>(queue.members);
  for (RayQueue::Row* row : {&queue.absorption, &queue.wave, &queue.absorbed}) row->resize(rays);
  const std::optional<LengthSampler>& size = sizes_[population];
  for (int place = 0; size && span && place < queue.count; ++place) {
    constexpr double kNanometres = 1e3;  // in a micrometre
    const auto words = randomWords(seed, RandomPurpose::size, 0, queue.bundle[place]);
    const double nmPerUnit = kNanometres * size->at(toUnitInterval(words.first)) / span->at(queue.stretch[place]);
    for (int member = 0; member < queue.members; ++member) {
      const int ray = queue.ray(member, place);
      const double wavelength = queue.light[ray].wavelength;
      queue.absorption[ray] = 4.0 * kPi * imaginaryIndex(ice_, wavelength) / wavelength * nmPerUnit;
      queue.wave[ray] = wavelength / nmPerUnit;
    }
  }
}

int Cloud::bundlesPerShape() const { return std::max(32, kRaysPerShape / bundleSize()); }

SpectralSample Cloud::light(std::uint64_t seed, std::uint64_t bundle, int member) const {
  if (!spectrum_.lines().empty()) return spectrum_.lines()[member];
  // The wavelengths of a bundle stand at equal distances in the spectrum, from a start that differs between bundles.
  return spectrum_.sample((member + goldenQuantile(seed, bundle)) / bundleSize());
}

}  // namespace parhelion
