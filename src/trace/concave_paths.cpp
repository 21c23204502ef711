// SPDX-License-Identifier: Apache-2.0
#include "trace/concave_paths.h"

#include <cmath>

namespace parhelion {

namespace {

/// Puts the light of one ray on the list of exits.
class ExitFilm {
 public:
  ExitFilm(const PathPlan& plan, int population, ExitList& exits, EnergyUnits& energy)
      : plan_(plan), population_(population), exits_(exits), energy_(energy) {}

  int ray = 0;

  PathMark meet(const PathMark& before, const ConcaveStep<PathMark>& step) const {
    PathMark mark = before;
    if (exits_.record == PathRecord::nothing) return mark;
    mark.state = plan_.automaton(population_).next(static_cast<int>(before.state), step.face);
    if (exits_.record == PathRecord::sequence)
      mark.words = plan_.code(population_).with(before.words, step.face, step.order);
    return mark;
  }

  void branches(const PathMark&, double, const Vec3&, double, const Vec3&) const {}

  void leave(const PathMark& mark, const Vec3& lightDir, double energy, int order) {
    exits_.reserve(1 + RayQueue::kSpare);
    const int place = exits_.count++;
    for (int k = 0; k < 3; ++k) exits_.lightDirCrystal[k][place] = lightDir[k];
    exits_.energy[place] = energy;
    exits_.ray[place] = ray;
    exits_.order[place] = order;
    energy_.out += std::llrint(energy * energy_.perLight);
    if (exits_.record == PathRecord::nothing) return;
    exits_.pathState[place] = mark.state;
    if (exits_.record != PathRecord::sequence) return;
    exits_.pathFirst[place] = mark.words.first;
    exits_.pathLast[place] = mark.words.last;
  }

 private:
  const PathPlan& plan_;
  int population_;
  ExitList& exits_;
  EnergyUnits& energy_;
};

}  // namespace

ConcavePaths::Counts ConcavePaths::follow(const ConcaveCrystal& crystal, const CrystalOptics& optics,
                                          const PathPlan& plan, int population, std::uint64_t seed, PathRule rule,
                                          int members, RayQueue& queue, ExitList& exits, EnergyUnits& energy) {
  Counts counts;
  ExitFilm film(plan, population, exits, energy);
  for (int member = 0; member < members; ++member)
    for (int place = 0; place < queue.count; ++place) {
      const auto at = [place](const RayQueue::Row* rows) {
        return Vec3(rows[0][place], rows[1][place], rows[2][place]);
      };
      film.ray = queue.ray(member, place);
      const double weight = queue.weight[place];
      const bool isIdeal = optics.isIdeal();
      const RayOptics own{queue.iceIndex[film.ray], optics, isIdeal ? 0.0 : queue.absorption[film.ray],
                          isIdeal ? 0.0 : queue.wave[film.ray]};
      ConcaveWalk walk(crystal, own, weight * rule.splitShare, pathRandom<double>(seed, queue.bundle[place]), film,
                       waiting_);
      walk.run({static_cast<int>(queue.face[place]), at(queue.point)}, at(queue.lightCrystal), weight, PathMark{});
      queue.internalPath[film.ray] = walk.internalPath;
      queue.lost[film.ray] = walk.lost;
      queue.cutOff[film.ray] = walk.cutOff;
      if (!isIdeal) {
        queue.absorbed[film.ray] = walk.absorbed;
        counts.absorbed.add(walk.absorbed);
      }
      energy.lost += std::llrint(walk.lost * energy.perLight);
      counts.hits += static_cast<std::uint64_t>(walk.hits);
      counts.rescued += static_cast<std::uint64_t>(walk.rescued);
    }
  return counts;
}

}  // namespace parhelion
