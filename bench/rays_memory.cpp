// SPDX-License-Identifier: Apache-2.0
#include "rays_memory.h"

#include <fstream>
#include <stdexcept>
#include <string>

#include <malloc.h>

namespace parhelion::bench {
namespace {

/// A line such as "VmHWM:   1234 kB" of a file of /proc, in bytes.
std::size_t lineOf(const char* path, const std::string& key) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(key)) return std::stoull(line.substr(key.size())) * 1024;
  throw std::runtime_error(std::string(path) + ": no " + key);
}

}  // namespace

void resetPeakMemory() {
  malloc_trim(0);  // what was freed is no longer resident
  std::ofstream file("/proc/self/clear_refs");
  file << "5" << std::flush;
  if (!file) throw std::runtime_error("/proc/self/clear_refs: cannot be written");
}

std::size_t peakMemory() { return lineOf("/proc/self/status", "VmHWM:"); }

std::size_t freeMemory() { return lineOf("/proc/meminfo", "MemAvailable:"); }

}  // namespace parhelion::bench
