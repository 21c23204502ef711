// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace parhelion {

/// Face sequences in two words: one has the first faces, the other the last. How many there are in all stands beside
/// them. Faces are indices into a mesh of `faces` faces.
class PathCode {
 public:
  explicit PathCode(int faces)
      : bits_(std::max(1, static_cast<int>(std::bit_width(static_cast<unsigned>(faces - 1))))) {}

  int bits() const { return bits_; }       // of a face
  int room() const { return 64 / bits_; }  // faces in a word

  struct Words {
    std::uint64_t first = 0, last = 0;

    bool operator==(const Words&) const = default;
  };

  /// The words after one more face, which is the one at `place`, from 0.
  Words with(Words words, int face, int place) const {
    const auto code = static_cast<std::uint64_t>(face);
    if (place < room()) words.first |= code << (bits_ * place);
    words.last = words.last << bits_ | code;
    return words;
  }

  /// The faces of a path of `count`: all of them, or the first room() and the last room() of longer ones.
  struct Faces {
    std::vector<int> first, last;
    int leftOut = 0;  // between them
  };
  Faces faces(const Words& words, int count) const {
    Faces all;
    const int first = count < room() ? count : room(), last = count - first < room() ? count - first : room();
    const std::uint64_t mask = (std::uint64_t{1} << bits_) - 1;
    for (int i = 0; i < first; ++i) all.first.push_back(static_cast<int>(words.first >> (bits_ * i) & mask));
    for (int i = last - 1; i >= 0; --i) all.last.push_back(static_cast<int>(words.last >> (bits_ * i) & mask));
    all.leftOut = count - first - last;
    return all;
  }

 private:
  int bits_;
};

}  // namespace parhelion
