// SPDX-License-Identifier: Apache-2.0
#include "trace/ray_source.h"

#include <algorithm>
#include <numeric>

#include "trace/concave_entry.h"

namespace parhelion {

namespace {

// The dimensions of a Sobol' point are the better spread the lower they are: what the light's way through the crystal
// depends on most comes first.
constexpr IncidenceNumber kByWeight[] = {kZenith, kRoll,    kAzimuth,   kEntryFace, kEntryS,
                                         kEntryT, kStretch, kSunRadius, kSunAngle};
constexpr int kPopulationDimension = std::size(kByWeight);

constexpr int kBlocks = kIncidenceNumbers / 2;

}  // namespace

RaySource::RaySource(const Cloud& cloud, const TraceSettings& settings, int room, const LaneSteps& steps)
    : cloud_(cloud),
      steps_(steps),
      seed_(settings.seed),
      sampler_(settings.sampler),
      room_(room),
      drawn_(cloud.populations().size()),
      waiting_(room + RayQueue::kSpare),
      candidates_(cloud.populations().size()) {
  // Two scrambles, so that the halves of a tally are independent estimates, each of a whole net of points. Seeds of
  // scenes have no sign bit.
  constexpr std::uint64_t kOtherHalf = std::uint64_t{1} << 63;
  if (settings.sampler == Sampler::sobol)
    sobol_ = {SobolPoints(settings.seed), SobolPoints(settings.seed ^ kOtherHalf)};
  for (std::size_t p = 0; p < cloud.populations().size(); ++p) {
    queues_.emplace_back(cloud.bundleSize());
    if (cloud.hasFixedLight()) setLight(queues_.back());
  }
}

void RaySource::draw(std::uint64_t first, int count) {
  if (cloud_.hasSpreadShapes()) drawCrystals(first / cloud_.bundlesPerShape());
  for (RayQueue& queue : queues_) queue.count = 0;
  waiting_.assign(count, 0);
  std::iota(waiting_.begin(), waiting_.end(), first);
  for (int attempt = 0; !waiting_.empty(); ++attempt) {
    splitByPopulation(attempt);
    waiting_.clear();
    for (int p = 0; p < static_cast<int>(queues_.size()); ++p) propose(p, attempt);
  }
  first_ = first;
  places_.clear();
  if (!cloud_.hasFixedLight())
    for (RayQueue& queue : queues_) setLight(queue);
  for (int p = 0; p < static_cast<int>(queues_.size()); ++p)
    if (!cloud_.optics(p).isIdeal())
      cloud_.putOptics(p, drawn_[p] ? drawn_[p]->span : cloud_.span(p), seed_, queues_[p]);
}

void RaySource::drawCrystals(std::uint64_t block) {
  for (std::size_t p = 0; p < drawn_.size(); ++p) {
    const Population& population = cloud_.populations()[p];
    if (population.isSpread() && !(drawn_[p] && drawn_[p]->block == block)) drawn_[p].emplace(population, seed_, block);
  }
}

const CrystalMesh& RaySource::mesh(int population) const {
  return drawn_[population] ? drawn_[population]->mesh : cloud_.populations()[population].mesh();
}

const FaceTable& RaySource::faces(int population) const {
  return drawn_[population] ? drawn_[population]->faces : cloud_.faces(population);
}

/// Deals the waiting bundles out to the populations that they try next.
void RaySource::splitByPopulation(int attempt) {
  for (auto& candidates : candidates_) candidates.clear();
  const std::vector<double>& shares = cloud_.shares(sampler_);
  const int count = static_cast<int>(waiting_.size()), last = static_cast<int>(shares.size()) - 1;
  waiting_.resize(count + RayQueue::kSpare);
  for (int i = 0; i < count; i += IncidenceNumbers::kRoom) {
    const int some = std::min(IncidenceNumbers::kRoom, count - i);
    auto& u = numbers_.row[0];
    if (last > 0 && drawsSobol(attempt))
      fillSobol(&waiting_[i], some, kPopulationDimension, u.data());
    else if (last > 0)
      steps_.draw(seed_, RandomPurpose::population, &waiting_[i], some, attempt, 1, numbers_);
    for (int k = 0; k < some; ++k) {
      const auto chosen = last > 0 ? std::ranges::upper_bound(shares, u[k]) - shares.begin() : 0;
      candidates_[std::min<std::ptrdiff_t>(chosen, last)].push_back(waiting_[i + k]);
    }
  }
}

void RaySource::propose(int population, int attempt) {
  auto& bundles = candidates_[population];
  const int count = static_cast<int>(bundles.size());
  bundles.resize(count + RayQueue::kSpare);
  IncidenceTable table = cloud_.incidence(population, sampler_);
  table.faces = &faces(population);
  const std::size_t before = waiting_.size();
  waiting_.resize(before + count + RayQueue::kSpare);
  Proposals proposals{nullptr, 0, waiting_.data() + before, 0};
  for (int i = 0; i < count; i += IncidenceNumbers::kRoom) {
    proposals.bundle = &bundles[i];
    proposals.count = std::min(IncidenceNumbers::kRoom, count - i);
    fill(proposals.bundle, proposals.count, attempt);
    RayQueue& queue = queues_[population];
    if (queue.makeRoom(queue.count + proposals.count) && cloud_.hasFixedLight()) setLight(queue);
    if (const ConcaveCrystal* concave = cloud_.concave(population))
      proposeConcave(*concave, table, numbers_, proposals, queue);
    else
      steps_.propose(table, numbers_, proposals, queue);
  }
  waiting_.resize(before + proposals.rejectedCount);
}

/// The numbers for some bundles' attempt.
void RaySource::fill(const std::uint64_t* bundles, int count, int attempt) {
  if (drawsSobol(attempt)) {
    for (int d = 0; d < kPopulationDimension; ++d) fillSobol(bundles, count, d, numbers_.row[kByWeight[d]].data());
    return;
  }
  // A point sun needs no numbers of its own.
  steps_.draw(seed_, RandomPurpose::incidence, bundles, count, kBlocks * attempt,
              cloud_.sun().isPoint() ? kBlocks - 1 : kBlocks, numbers_);
}

void RaySource::fillSobol(const std::uint64_t* bundles, int count, int dimension, double* numbers) {
  std::array<std::uint64_t, IncidenceNumbers::kRoom> index;
  std::array<double, IncidenceNumbers::kRoom> point;
  for (std::uint64_t half = 0; half < 2; ++half) {
    int some = 0;
    for (int i = 0; i < count; ++i)
      if (bundles[i] % 2 == half) index[some++] = bundles[i] / 2;
    sobol_[half].fill(index.data(), some, dimension, point.data());
    some = 0;
    for (int i = 0; i < count; ++i)
      if (bundles[i] % 2 == half) numbers[i] = point[some++];
  }
}

void RaySource::setLight(RayQueue& queue) {
  const int count = cloud_.hasFixedLight() ? queue.room : queue.count;
  for (int member = 0; member < queue.members; ++member)
    for (int place = 0; place < count; ++place) {
      const int ray = queue.ray(member, place);
      queue.light[ray] = cloud_.light(seed_, queue.bundle[place], member);
      queue.iceIndex[ray] = cloud_.iceIndex(queue.light[ray].wavelength, queue.bundle[place]);
    }
}

IncidentRay RaySource::ray(std::uint64_t index) {
  const std::uint64_t bundle = index / cloud_.bundleSize();
  if (places_.empty() || bundle < first_ || bundle >= first_ + places_.size()) {
    const auto block = static_cast<std::uint64_t>(cloud_.bundlesPerShape());
    const int count = cloud_.hasSpreadShapes() ? std::min(room_, static_cast<int>(block - bundle % block)) : room_;
    draw(bundle, count);
    places_.resize(count);
    for (int p = 0; p < static_cast<int>(queues_.size()); ++p)
      for (int place = 0; place < queues_[p].count; ++place) places_[queues_[p].bundle[place] - first_] = {p, place};
  }
  const auto [population, place] = places_[bundle - first_];
  const RayQueue& q = queues_[population];
  const auto vec = [place = place](const RayQueue::Row* rows) {
    return Vec3(rows[0][place], rows[1][place], rows[2][place]);
  };
  const int ray = q.ray(static_cast<int>(index % cloud_.bundleSize()), place);
  const bool isIdeal = cloud_.optics(population).isIdeal();
  return {index,
          bundle,
          population,
          {&mesh(population), q.stretch[place]},
          Mat3(vec(q.crystalX), vec(q.crystalY), vec(q.crystalZ)),
          vec(q.lightWorld),
          vec(q.lightCrystal),
          {static_cast<int>(q.face[place]), vec(q.point)},
          q.shadow[place],
          q.light[ray],
          q.iceIndex[ray],
          q.weight[place],
          cloud_.optics(population),
          isIdeal ? 0.0 : q.absorption[ray],
          isIdeal ? 0.0 : q.wave[ray]};
}

}  // namespace parhelion
