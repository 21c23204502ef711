// SPDX-License-Identifier: Apache-2.0
#include "sky/deposit_buffer.h"

#include <thread>
#include <vector>

#include <doctest/doctest.h>

#include "random_stream.h"

using namespace parhelion;

namespace {

Tally tallyOf(int width, int height, int colours) {
  TallyInfo info;
  info.camera.width = width;
  info.camera.height = height;
  return Tally(info, colours);
}

constexpr int kDeposits = 20'000;

/// Calls `add(pixel, xyz, bundle)` with the deposits of one thread, many of them into the same pixels.
template <class Add>
void deposit(const Tally& tally, int thread, Add&& add) {
  for (int i = 0; i < kDeposits; ++i) {
    RandomStream random(thread, i, RandomPurpose::path);
    const double where = random.next(), x = random.next(), y = random.next(), z = random.next();
    add(static_cast<int>(where * where * tally.pixels()), Vec3(x, y, z), static_cast<std::uint64_t>(i));
  }
}

}  // namespace

TEST_CASE("deposits that threads gather in buffers make the tally that single deposits make") {
  for (const int colours : {1, 3})
    for (const auto& [width, height] : std::vector<std::pair<int, int>>{{1, 1}, {7, 9}, {8, 8}, {65, 1}, {301, 203}}) {
      constexpr int kThreads = 4;
      Tally single = tallyOf(width, height, colours), gathered = tallyOf(width, height, colours);
      const auto locks = std::make_shared<DepositBuffer::Locks>();
      std::vector<std::thread> threads;
      for (int t = 0; t < kThreads; ++t) {
        deposit(single, t,
                [&](int pixel, const Vec3& xyz, std::uint64_t bundle) { single.add(pixel, xyz, bundle % 2 == 0); });
        threads.emplace_back([&gathered, &locks, t] {
          DepositBuffer buffer(gathered, locks);
          deposit(gathered, t, [&](int pixel, const Vec3& xyz, std::uint64_t bundle) {
            buffer.add(pixel, toFixedLight(xyz, gathered.perWhite()), bundle);
          });
          buffer.flush();
        });
      }
      for (std::thread& thread : threads) thread.join();
      CHECK(gathered == single);
    }
}

TEST_CASE("whatever a bundle brings to a pixel is one deposit, however many it makes") {
  constexpr int kWidth = 30, kHeight = 20;
  Tally summed = tallyOf(kWidth, kHeight, 3), gathered = summed;
  DepositBuffer buffer(gathered, std::make_shared<DepositBuffer::Locks>());
  for (std::uint64_t bundle = 0; bundle < 300; ++bundle) {
    // From none to several times what is gathered of one band, in pixels of few bands.
    const int count = bundle % 10 == 0 ? 1000 : static_cast<int>(bundle % 7);
    std::vector<FixedLight> sums(kWidth * kHeight);
    for (int i = 0; i < count; ++i) {
      RandomStream random(bundle, i, RandomPurpose::path);
      const double where = random.next();
      const int pixel = static_cast<int>(where * where * where * kWidth * kHeight);
      const FixedLight light = toFixedLight(Vec3(random.next(), random.next(), random.next()), summed.perWhite());
      buffer.add(pixel, light, bundle);
      sums[static_cast<std::size_t>(pixel)] += light;
    }
    for (int pixel = 0; pixel < kWidth * kHeight; ++pixel)
      if (const FixedLight& sum = sums[static_cast<std::size_t>(pixel)]; sum != FixedLight())
        summed.addExclusively(pixel, sum, bundle % 2 == 0);
  }
  buffer.flush();
  CHECK(gathered == summed);
}

TEST_CASE("a buffer stays as small in a long run as in a short one") {
  Tally tally = tallyOf(32, 32, 1);
  DepositBuffer buffer(tally, std::make_shared<DepositBuffer::Locks>());
  const auto roomAfter = [&](std::uint64_t from, std::uint64_t to) {
    for (std::uint64_t bundle = from; bundle < to; ++bundle)
      for (int i = 0; i < 6; ++i) {
        RandomStream random(bundle, i, RandomPurpose::path);
        buffer.add(static_cast<int>(random.next() * tally.pixels()), toFixedLight(Vec3(1.0), tally.perWhite()), bundle);
      }
    return buffer.room();
  };
  const std::size_t atFirst = roomAfter(0, 2000);
  CHECK(roomAfter(2000, 100'000) == atFirst);
}
