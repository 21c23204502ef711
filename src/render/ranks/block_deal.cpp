// SPDX-License-Identifier: Apache-2.0
#include "render/ranks/block_deal.h"

#include <algorithm>

namespace parhelion {

namespace {

// Long beside the microseconds that a message takes, short for a stop: a rank has a second block waiting.
constexpr double kBlockSeconds = 0.2;
constexpr std::uint64_t kFirstBundles = 256;  // of a rank's first block, whose speed is unknown
constexpr std::uint64_t kLeastBundles = 32;   // of a block: fewer fill no wave (trace/wave.h)

}  // namespace

BlockDeal::BlockDeal(const RayRange& range, std::uint64_t bundleSize, int ranks)
    : left_(range), bundleSize_(bundleSize), first_(range.first), raysPerSecond_(static_cast<std::size_t>(ranks)) {}

RayRange BlockDeal::next(int rank) {
  const std::lock_guard lock(mutex_);
  const double speed = raysPerSecond_[static_cast<std::size_t>(rank)];
  const std::uint64_t wanted =
      speed > 0.0 ? static_cast<std::uint64_t>(speed * kBlockSeconds) : kFirstBundles * bundleSize_;
  const std::uint64_t share = left_.count / (2 * raysPerSecond_.size());
  const std::uint64_t bundles = std::max(kLeastBundles, std::min(wanted, share) / bundleSize_);
  const RayRange block{left_.first, std::min(bundles * bundleSize_, left_.count)};
  left_ = {left_.first + block.count, left_.count - block.count};
  return block;
}

void BlockDeal::note(int rank, std::uint64_t rays, double seconds) {
  const std::lock_guard lock(mutex_);
  done_ += rays;
  // One that was slowed down by others, or was too short to be timed, says little.
  double& speed = raysPerSecond_[static_cast<std::size_t>(rank)];
  const double now = static_cast<double>(rays) / std::max(seconds, 1e-3);
  speed = speed > 0.0 ? std::clamp(now, speed / 4.0, speed * 4.0) : now;
}

void BlockDeal::close() {
  const std::lock_guard lock(mutex_);
  left_.count = 0;
}

std::uint64_t BlockDeal::dealt() const {
  const std::lock_guard lock(mutex_);
  return left_.first - first_;
}

std::uint64_t BlockDeal::done() const {
  const std::lock_guard lock(mutex_);
  return done_;
}

}  // namespace parhelion
