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

/// Calls `add(pixel, xyz, firstHalf)` with the deposits of one thread, many of them into the same pixels.
template <class Add>
void deposit(const Tally& tally, int thread, Add&& add) {
  for (int i = 0; i < kDeposits; ++i) {
    RandomStream random(thread, i, RandomPurpose::path);
    const double where = random.next(), x = random.next(), y = random.next(), z = random.next();
    add(static_cast<int>(where * where * tally.pixels()), Vec3(x, y, z), i % 2 == 0);
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
        deposit(single, t, [&](int pixel, const Vec3& xyz, bool half) { single.add(pixel, xyz, half); });
        threads.emplace_back([&gathered, &locks, t] {
          DepositBuffer buffer(gathered, locks);
          deposit(gathered, t, [&](int pixel, const Vec3& xyz, bool half) {
            buffer.add(pixel, toFixedLight(xyz, gathered.perWhite()), half);
          });
          buffer.flush();
        });
      }
      for (std::thread& thread : threads) thread.join();
      CHECK(gathered == single);
    }
}
