// SPDX-License-Identifier: Apache-2.0
// Patterns of raypaths: one a line, read, compiled together for a prism and a pyramid, and run along some paths.
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "crystal/population.h"
#include "crystal/raypath/path_automaton.h"
#include "crystal/raypath/path_symmetry.h"

namespace {

using namespace parhelion;

std::vector<PathPattern> patternsIn(std::string_view text) {
  constexpr std::size_t kMostPatterns = 3;
  std::vector<PathPattern> patterns;
  while (patterns.size() < kMostPatterns) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    try {
      patterns.push_back(parsePathPattern(text.substr(0, end)));
    } catch (const PatternError& error) {
      if (error.at > end) __builtin_trap();  // a place that is not in the text
    }
    if (end == text.size()) break;
    text.remove_prefix(end + 1);
  }
  return patterns;
}

void run(const std::vector<PathPattern>& patterns, const CrystalMesh& mesh) {
  std::vector<int> numbers;
  for (const Face& face : mesh.faces()) numbers.push_back(face.number);
  std::vector<SymmetricPattern> compiled;
  for (const PathPattern& pattern : patterns)
    compiled.push_back({&pattern, pathSymmetries(mesh, RandomOrientation{}, pattern.symmetry)});
  try {
    const PathAutomaton automaton(numbers, compiled);
    int state = PathAutomaton::kStart;
    for (int i = 0; i < 1000; ++i) {
      state = automaton.next(state, i * 7 % automaton.faces());
      if (state <= 0 || state >= automaton.states()) __builtin_trap();
    }
  } catch (const std::invalid_argument&) {  // too intricate
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const CrystalMesh prism = hexagonalPrism(0.5), pyramid = hexagonalPyramid({0.5, 0.5, 0.3});
  const std::vector<PathPattern> patterns = patternsIn({reinterpret_cast<const char*>(data), size});
  run(patterns, prism);
  run(patterns, pyramid);
  return 0;
}
