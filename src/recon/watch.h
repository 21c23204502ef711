// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <stdexcept>

namespace parhelion {

/// A reconstruction was asked to stop.
struct ReconStopped : std::runtime_error {
  ReconStopped() : std::runtime_error("the reconstruction was stopped") {}
};

/// How a long reconstruction is followed and stopped from outside.
struct Watch {
  std::function<void(double share)> onProgress;  // of the work done, 0 to 1
  const std::atomic<bool>* stop = nullptr;

  /// To be called between the steps of a method, by the thread that runs it. Throws ReconStopped.
  void at(double share) const {
    if (stop != nullptr && stop->load(std::memory_order_relaxed)) throw ReconStopped();
    if (onProgress) onProgress(share);
  }
};

}  // namespace parhelion
