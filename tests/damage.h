// SPDX-License-Identifier: Apache-2.0
#pragma once

// Files that are damaged in every way there is: each must be refused, or read as it was before the damage.

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdlib>
#include <random>
#include <stdexcept>
#include <string>

#include "picture/temporary_directory.h"

namespace parhelion::test {

/// How thoroughly files are damaged: `bits` single flipped bits, and every `step`th length. scripts/damage asks for
/// all.
struct Damage {
  int bits = 300;
  std::size_t step = 41;

  static Damage asked() {
    const char* bits = std::getenv("PARHELION_FLIPPED_BITS");
    return bits ? Damage{std::atoi(bits), 1} : Damage{};
  }
};

/// What became of the damaged copies of a file.
struct Survived {
  int refused = 0, readRight = 0, readWrong = 0;
};

/// `readsRight` reads the file at `path` and says whether it is what was written; it may throw std::runtime_error.
template <class ReadsRight>
Survived damaged(const std::filesystem::path& path, const ReadsRight& readsRight) {
  const std::string whole = contents(path);
  Survived survived;
  const auto tryCopy = [&](const std::string& bytes) {
    put(path, bytes);
    try {
      ++(readsRight() ? survived.readRight : survived.readWrong);
    } catch (const std::runtime_error&) {
      ++survived.refused;
    }
  };
  const Damage damage = Damage::asked();
  std::mt19937_64 random(3);
  for (int i = 0; i < damage.bits; ++i) {
    std::string bytes = whole;
    const std::size_t bit = random() % (8 * bytes.size());
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ 1 << bit % 8);
    tryCopy(bytes);
  }
  for (std::size_t length = 0; length < whole.size(); length += damage.step) tryCopy(whole.substr(0, length));
  tryCopy(whole.substr(0, whole.size() - 1));
  put(path, whole);
  MESSAGE(survived.refused << " refused, " << survived.readRight << " read right, " << survived.readWrong << " wrong");
  return survived;
}

}  // namespace parhelion::test
