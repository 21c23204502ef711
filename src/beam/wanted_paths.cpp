// SPDX-License-Identifier: Apache-2.0
#include "beam/wanted_paths.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace parhelion {

namespace {

using Faces = std::array<int, kPrismFaces>;

constexpr Faces kTurned{1, 2, 3, 4, 5, 0, kUpperEnd, kLowerEnd}, kMirrored{0, 5, 4, 3, 2, 1, kUpperEnd, kLowerEnd},
    kUpsideDown{0, 1, 2, 3, 4, 5, kLowerEnd, kUpperEnd};

/// The place of a face in a prism by its crystallographic number.
int placeOf(int number) {
  if (number >= 3 && number <= 8) return number - 3;
  if (number == 1 || number == 2) return kUpperEnd + number - 1;
  throw std::invalid_argument("a prism has no face " + std::to_string(number));
}

}  // namespace

WantedPaths::WantedPaths(const PathAutomaton& automaton, std::span<const int> numbers, std::vector<bool> wanted)
    : WantedPaths(
          [&] {
            std::vector<Faces> next(static_cast<std::size_t>(automaton.states()));
            for (int state = 0; state < automaton.states(); ++state)
              for (int face = 0; face < automaton.faces(); ++face)
                next[static_cast<std::size_t>(state)]
                    [static_cast<std::size_t>(placeOf(numbers[static_cast<std::size_t>(face)]))] =
                        automaton.next(state, face);
            return next;
          }(),
          std::move(wanted)) {
  if (automaton.faces() != kPrismFaces) throw std::invalid_argument("a prism has eight faces");
  findOthers();
}

WantedPaths::WantedPaths(std::vector<Faces> next, std::vector<bool> wanted)
    : next_(std::move(next)), wanted_(std::move(wanted)), goesOn_(next_.size(), false) {
  for (bool found = true; found;) {
    found = false;
    for (std::size_t state = 0; state < next_.size(); ++state) {
      const auto leads = [&](int to) {
        return wanted_[static_cast<std::size_t>(to)] || goesOn_[static_cast<std::size_t>(to)];
      };
      if (goesOn_[state] || std::ranges::none_of(next_[state], leads)) continue;
      goesOn_[state] = found = true;
    }
  }
  areShort_ = findShort();
}

bool WantedPaths::findShort() const {
  std::set<int> going;
  if (goesOn(kStart)) going.insert(kStart);
  for (int faces = 1; faces < kShort; ++faces) {
    std::set<int> further;
    for (const int state : going)
      for (const int to : next_[static_cast<std::size_t>(state)])
        if (goesOn(to)) further.insert(to);
    going = std::move(further);
  }
  return going.empty();
}

WantedPaths WantedPaths::others() const {
  std::vector<bool> wanted = wanted_;
  wanted.flip();
  return {next_, std::move(wanted)};
}

void WantedPaths::findOthers() {
  if (areShort_) return;
  auto all = std::make_shared<const WantedPaths>(others());
  if (all->areShort()) shortOthers_ = std::move(all);
}

WantedPaths WantedPaths::upsideDown() const {
  std::vector<Faces> next = next_;
  for (Faces& faces : next) std::swap(faces[kUpperEnd], faces[kLowerEnd]);
  WantedPaths turned(std::move(next), wanted_);
  turned.findOthers();
  return turned;
}

bool WantedPaths::areAlike(const Faces& images) const {
  // Both are followed side by side, along all paths.
  std::set<std::pair<int, int>> known{{kStart, kStart}};
  std::vector<std::pair<int, int>> waiting{{kStart, kStart}};
  while (!waiting.empty()) {
    const auto [a, b] = waiting.back();
    waiting.pop_back();
    for (int face = 0; face < kPrismFaces; ++face) {
      const std::pair<int, int> met{next(a, face), next(b, images[static_cast<std::size_t>(face)])};
      if (isWanted(met.first) != isWanted(met.second)) return false;
      if (known.insert(met).second) waiting.push_back(met);
    }
  }
  return true;
}

bool WantedPaths::areAlikeMirrored() const { return areAlike(kMirrored); }

bool WantedPaths::areAlikeAboutC() const { return areAlike(kTurned) && areAlikeMirrored(); }

bool WantedPaths::areAlikeUpsideDown() const { return areAlike(kUpsideDown); }

}  // namespace parhelion
