// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <stdexcept>
#include <string>
#include <utility>

#include "trace/embree_api.h"
#include "trace/embree_intersector.h"

namespace parhelion {

// Embree calls back from C: the callbacks only record, and check() throws afterwards.
struct EmbreeDevice::State {
  RTCDevice device = nullptr;
  std::size_t memoryLimit = 0;
  std::atomic<long long> memory{0};
  std::string error;

  ~State() {
    if (device) rtcReleaseDevice(device);
  }

  static void recordError(void* self, RTCError code, const char* message) {
    auto& error = static_cast<State*>(self)->error;
    if (!error.empty()) return;
    error = code == RTC_ERROR_OUT_OF_MEMORY ? "out of memory" : "error " + std::to_string(code);
    if (message && *message) error += std::string(" (") + message + ")";
  }

  static bool watchMemory(void* self, ssize_t bytes, bool) {
    auto& state = *static_cast<State*>(self);
    const long long total = state.memory += bytes;
    return bytes <= 0 || state.memoryLimit == 0 || total <= static_cast<long long>(state.memoryLimit);
  }

  void check(const char* doing) {
    if (error.empty()) return;
    throw std::runtime_error(std::string("Embree failed while ") + doing + ": " + std::exchange(error, {}));
  }
};

}  // namespace parhelion
