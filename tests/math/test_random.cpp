// SPDX-License-Identifier: Apache-2.0
#include "math/random.h"

#include <limits>
#include <set>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "random_stream.h"
#include "statistics.h"

using namespace parhelion;

namespace {

using Block = PhiloxBlock<std::uint64_t>;

bool gives(const Block& counter, std::uint64_t key, const Block& answer) {
  const Block block = philox(counter, key);
  return lowWord(block.a) == answer.a && lowWord(block.b) == answer.b && lowWord(block.c) == answer.c &&
         lowWord(block.d) == answer.d;
}

constexpr auto kAllPurposes = {RandomPurpose::incidence, RandomPurpose::path, RandomPurpose::pilot};

}  // namespace

// The known answers that Random123 1.09 publishes for philox4x32 with ten rounds (kat_vectors).
TEST_CASE("Philox4x32-10 gives the published answers") {
  constexpr std::uint64_t kOnes = 0xffffffff;
  CHECK(gives({0, 0, 0, 0}, 0, {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  CHECK(gives({kOnes, kOnes, kOnes, kOnes}, kOnes << 32 | kOnes, {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  CHECK(gives({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, 0x299f31d0'a4093822,
              {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST_CASE("random numbers lie strictly between 0 and 1, for any bits") {
  constexpr auto kAll = std::numeric_limits<std::uint64_t>::max();
  CHECK(toUnitInterval(0) == 0x1p-53);
  CHECK(toUnitInterval(0xfff) == 0x1p-53);
  CHECK(toUnitInterval(kAll) == 1.0 - 0x1p-53);
  for (int bit = 0; bit < 64; ++bit) {
    for (const std::uint64_t bits : {std::uint64_t{1} << bit, kAll >> bit, kAll << bit, ~(std::uint64_t{1} << bit)}) {
      CHECK(toUnitInterval(bits) > 0.0);
      CHECK(toUnitInterval(bits) < 1.0);
      // Mirrored bits give the mirrored number: neither end is favoured.
      CHECK(toUnitInterval(~bits) == 1.0 - toUnitInterval(bits));
    }
  }
}

TEST_CASE("a random stream is a function of seed, ray and purpose alone") {
  RandomStream a(7, 42, RandomPurpose::path), b(7, 42, RandomPurpose::path);
  for (int i = 0; i < 100; ++i) CHECK(a.next() == b.next());
}

TEST_CASE("no two random streams begin alike, whatever differs between them") {
  std::set<double> first, second;
  std::size_t streams = 0;
  constexpr std::uint64_t kHigh = std::uint64_t{1} << 32;
  for (std::uint64_t seed = 0; seed < 40; ++seed)
    for (std::uint64_t ray = 0; ray < 400; ++ray)
      for (const auto purpose : kAllPurposes) {
        // Half of the seeds and rays differ in their upper words only.
        RandomStream stream(seed % 2 ? seed : seed * kHigh, ray % 2 ? ray : ray * kHigh, purpose);
        first.insert(stream.next());
        second.insert(stream.next());
        ++streams;
      }
  // Even one chance collision among these 48,000 numbers of 52 bits has a probability of 3e-7.
  CHECK(first.size() == streams);
  CHECK(second.size() == streams);
}

TEST_CASE("a random stream does not repeat itself") {
  RandomStream stream(1, 2, RandomPurpose::incidence);
  std::set<double> seen;
  for (int i = 0; i < 100000; ++i) seen.insert(stream.next());
  CHECK(seen.size() == 100000);
}

TEST_CASE("random numbers are uniform along a stream and from ray to ray") {
  constexpr int kDraws = 400000, kBins = 256;
  const auto uniform = [](double x) { return x; };
  std::vector<double> along, across;
  RandomStream stream(11, 5, RandomPurpose::path);
  for (int i = 0; i < kDraws; ++i) {
    along.push_back(stream.next());
    across.push_back(RandomStream(11, i, RandomPurpose::incidence).next());
  }
  CHECK(chiSquareSigma(along, uniform, 0.0, 1.0, kBins) < kSigmas);
  CHECK(chiSquareSigma(across, uniform, 0.0, 1.0, kBins) < kSigmas);
}

TEST_CASE("successive random numbers are independent, and so are those of neighbouring rays and purposes") {
  constexpr int kPairs = 200000, kGrid = 16;
  const auto sigmaOf = [&](const auto& pairAt) {
    std::vector<double> counts(kGrid * kGrid, 0.0);
    for (int i = 0; i < kPairs; ++i) {
      const std::pair<double, double> pair = pairAt(i);
      ++counts[static_cast<int>(pair.first * kGrid) * kGrid + static_cast<int>(pair.second * kGrid)];
    }
    return chiSquareSigma(counts, std::vector<double>(kGrid * kGrid, kPairs / double(kGrid * kGrid)));
  };
  const auto at = [](std::uint64_t ray, RandomPurpose purpose) { return RandomStream(3, ray, purpose).next(); };
  CHECK(sigmaOf([](int i) {
          RandomStream stream(3, i, RandomPurpose::path);
          const double x = stream.next();
          return std::pair(x, stream.next());
        }) < kSigmas);
  CHECK(sigmaOf([&](int i) { return std::pair(at(2 * i, RandomPurpose::path), at(2 * i + 1, RandomPurpose::path)); }) <
        kSigmas);
  CHECK(sigmaOf([&](int i) { return std::pair(at(i, RandomPurpose::path), at(i, RandomPurpose::incidence)); }) <
        kSigmas);
}
