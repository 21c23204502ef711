// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "beam/prism_light.h"
#include "crystal/raypath/path_automaton.h"

namespace parhelion {

/// Which light in a prism is wanted, by the faces that it meets from the first on: those of PrismLight. A number stands
/// for all that was met so far.
class WantedPaths {
 public:
  /// `numbers` are the crystallographic numbers of the automaton's faces, which must be those of a prism. `wanted`: by
  /// state of the automaton, whether light is that has come to it and leaves.
  WantedPaths(const PathAutomaton& automaton, std::span<const int> numbers, std::vector<bool> wanted);

  /// Before the first face.
  static constexpr int kStart = PathAutomaton::kStart;

  int next(int state, int face) const { return next_[static_cast<std::size_t>(state)][static_cast<std::size_t>(face)]; }
  bool isWanted(int state) const { return wanted_[static_cast<std::size_t>(state)]; }

  /// Whether any light is wanted that has come to this state and goes on inside.
  bool goesOn(int state) const { return goesOn_[static_cast<std::size_t>(state)]; }

  bool isNothing() const { return !goesOn_[kStart]; }

  /// Whether all paths that are wanted have less faces than this.
  static constexpr int kShort = 10;
  bool areShort() const { return areShort_; }

  /// All that is not wanted here.
  WantedPaths others() const;

  /// The same where these are not short but those are; else null.
  const WantedPaths* shortOthers() const { return shortOthers_.get(); }

  /// The same for crystals whose ends have changed places.
  WantedPaths upsideDown() const;

  /// Whether the same is wanted after a turn by 60 degrees about c and after a reflection in a plane through c, so that
  /// it does not matter from where about c light comes.
  bool areAlikeAboutC() const;

  /// Whether the same is wanted after a reflection in the plane through c that is across faces 3 and 6.
  bool areAlikeMirrored() const;

  /// Whether the same is wanted upside down.
  bool areAlikeUpsideDown() const;

 private:
  using Faces = std::array<int, kPrismFaces>;
  WantedPaths(std::vector<Faces> next, std::vector<bool> wanted);
  bool findShort() const;
  void findOthers();
  bool areAlike(const Faces& images) const;

  std::vector<Faces> next_;  // states by face
  std::vector<bool> wanted_, goesOn_;
  bool areShort_ = false;
  std::shared_ptr<const WantedPaths> shortOthers_;
};

}  // namespace parhelion
