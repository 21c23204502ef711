// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace parhelion {

/// What a run keeps of the faces that its rays meet; each kind has what the one before has. Tracing steps are compiled
/// for each, so that what a scene does not ask for costs nothing.
enum class PathRecord {
  nothing,
  state,     // the state of the population's PathAutomaton
  sequence,  // and the faces themselves, as PathCode keeps them
};

inline constexpr std::size_t kPathRecords = 3;

/// The automaton and the code of a population's paths, as plain numbers that lanes can run on.
struct PathTable {
  const double* next = nullptr;  // PathAutomaton::table()
  double faces = 0.0;            // of the crystal
  int bits = 0, room = 0;        // of PathCode
};

}  // namespace parhelion
