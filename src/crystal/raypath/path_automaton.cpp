// SPDX-License-Identifier: Apache-2.0
#include "crystal/raypath/path_automaton.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

namespace parhelion {

namespace {

/// Faces of a mesh as bits.
using FaceBits = std::bitset<kMostPatternFaces>;

/// A place of one image of a pattern's chain.
struct Step {
  FaceBits faces;         // that may be met here
  FaceBits asFirst;       // the same, where the path begins
  FaceBits asLast;        // with which a path of the pattern may end here
  std::vector<int> next;  // steps
  int pattern;
};

/// All that has been met, as far as any pattern cares.
struct Met {
  std::vector<int> steps;  // sorted
  int face = -1;           // the last one, where a step ends with some of its faces only
  int hits = 0;            // up to one more than any pattern counts

  auto operator<=>(const Met&) const = default;
};

class Builder {
 public:
  Builder(std::span<const int> numbers, std::span<const SymmetricPattern> patterns)
      : numbers_(numbers), patterns_(patterns) {
    for (int p = 0; p < static_cast<int>(patterns.size()); ++p) {
      const PathPattern& pattern = *patterns[p].pattern;
      countedHits_ = std::max(countedHits_, pattern.fewestHits - 1);
      if (pattern.mostHits <= kMostPatternHits) countedHits_ = std::max(countedHits_, pattern.mostHits);
      // Different isometries may have the same images of what a pattern names.
      std::vector<std::vector<FaceBits>> known;
      for (const std::vector<int>& images : patterns[p].images) addImage(p, images, known);
    }
  }

  const std::vector<Step>& steps() const { return steps_; }

  Met after(const Met& met, int face, bool isStart) const {
    const auto has = [face](const FaceBits& faces) {
      return face < kMostPatternFaces && faces.test(static_cast<std::size_t>(face));
    };
    Met next;
    next.hits = std::min(met.hits + 1, countedHits_ + 1);
    const auto enter = [&](int step) {
      if (has(isStart ? steps_[step].asFirst : steps_[step].faces)) next.steps.push_back(step);
    };
    if (isStart)
      for (const int step : first_) enter(step);
    else
      for (const int from : met.steps)
        for (const int step : steps_[from].next) enter(step);
    std::ranges::sort(next.steps);
    next.steps.erase(std::unique(next.steps.begin(), next.steps.end()), next.steps.end());
    for (const int step : next.steps)
      if (steps_[step].asLast.any() && steps_[step].asLast != steps_[step].faces) next.face = face;
    return next;
  }

  PathAutomaton::Patterns accepted(const Met& met) const {
    PathAutomaton::Patterns taken;
    for (const int step : met.steps) {
      const Step& s = steps_[step];
      const bool mayEnd = s.asLast.any() && (met.face < 0 || s.asLast.test(static_cast<std::size_t>(met.face)));
      if (mayEnd && counts(s.pattern, met.hits)) taken.set(static_cast<std::size_t>(s.pattern));
    }
    for (std::size_t p = 0; p < patterns_.size(); ++p)
      if (patterns_[p].pattern->isInverted) taken.flip(p);
    return taken;
  }

 private:
  bool counts(int pattern, int hits) const {
    const PathPattern& p = *patterns_[pattern].pattern;
    return hits >= p.fewestHits && hits <= p.mostHits;
  }

  FaceBits imageOf(const FaceChoice& choice, const std::vector<int>& images) const {
    FaceBits bits;
    for (std::size_t i = 0; i < numbers_.size(); ++i)
      if (choice.has(numbers_[i])) bits.set(static_cast<std::size_t>(images[i]));
    return bits;
  }

  void addImage(int p, const std::vector<int>& images, std::vector<std::vector<FaceBits>>& known) {
    const PathPattern& pattern = *patterns_[p].pattern;
    const FaceBits entry = imageOf(pattern.entry, images), exit = imageOf(pattern.exit, images);
    std::vector<FaceBits> faces{entry, exit};
    for (const PathPattern::Place& place : pattern.places) faces.push_back(imageOf(place.faces, images));
    if (std::ranges::find(known, faces) != known.end()) return;
    known.push_back(faces);
    const int base = static_cast<int>(steps_.size());
    for (std::size_t i = 0; i < pattern.places.size(); ++i) {
      const PathPattern::Place& place = pattern.places[i];
      const FaceBits own = faces[i + 2];
      Step step{own, own & entry, place.isLast ? own & exit : FaceBits(), {}, p};
      for (const int next : place.next) step.next.push_back(base + next);
      steps_.push_back(std::move(step));
    }
    for (const int first : pattern.first) first_.push_back(base + first);
  }

  std::span<const int> numbers_;
  std::span<const SymmetricPattern> patterns_;
  std::vector<Step> steps_;
  std::vector<int> first_;
  int countedHits_ = 0;
};

}  // namespace

PathAutomaton::PathAutomaton(std::span<const int> faceNumbers, std::span<const SymmetricPattern> patterns)
    : faces_(static_cast<int>(faceNumbers.size())) {
  if (patterns.size() > kMostPatterns)
    throw std::invalid_argument("there may be " + std::to_string(kMostPatterns) + " patterns of raypaths at the most");
  if (faces_ > kMostPatternFaces && !patterns.empty())
    throw std::invalid_argument("patterns of raypaths are for crystals of at most " +
                                std::to_string(kMostPatternFaces) + " faces");
  const Builder builder(faceNumbers, patterns);
  // Subset construction. The start is a state of its own, which nothing leads back to.
  std::map<Met, int> stateOf;
  std::vector<Met> waiting{Met{}};
  accepted_.emplace_back();
  for (int state = 0; state < static_cast<int>(waiting.size()); ++state) {
    for (int face = 0; face < faces_; ++face) {
      Met met = builder.after(waiting[state], face, state == kStart);
      const auto [found, isNew] = stateOf.try_emplace(met, static_cast<int>(waiting.size()));
      if (isNew) {
        if (states() == kMostStates)
          throw std::invalid_argument("these patterns of raypaths are too intricate together: fewer '*', '|' or hits");
        accepted_.push_back(builder.accepted(met));
        waiting.push_back(std::move(met));
      }
      next_.push_back(found->second);
    }
  }
}

PathAutomaton::Patterns PathAutomaton::acceptedAfter(std::span<const int> faces) const {
  int state = kStart;
  for (const int face : faces) state = next(state, face);
  return accepted(state);
}

}  // namespace parhelion
